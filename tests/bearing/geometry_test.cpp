#include "bearing/geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "bearing/bearing.h"
#include "bearing/operating_point.h"

namespace raceway::bearing {
namespace {

using testing::AllOf;
using testing::HasSubstr;

BearingGeometry good() {
  return {.ball_count = 18,
          .ball_diameter = 12.7 * mm,
          .pitch_diameter = 90 * mm,
          .contact_angle = 25 * degree,
          .inner_conformity = 0.525,
          .outer_conformity = 0.515};
}

/// The message with which a geometry is refused, empty if it is not.
std::string refusal(const std::function<void(BearingGeometry&)>& spoil) {
  BearingGeometry geometry = good();
  spoil(geometry);
  try {
    (void)validated(geometry);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Geometry, AGoodOneIsAcceptedAndCompleted) {
  const BearingGeometry g = validated(good());
  EXPECT_DOUBLE_EQ(g.bore, 90 * mm - 1.5 * 12.7 * mm);
  EXPECT_DOUBLE_EQ(g.outer_diameter, 90 * mm + 1.5 * 12.7 * mm);
  EXPECT_TRUE(std::isnan(g.static_load_rating));
  EXPECT_NEAR(g.groove_centre_distance(), 0.04 * 12.7 * mm, 1e-16);
  EXPECT_NEAR(g.inner_groove_centre_radius(), 45 * mm + 0.025 * 12.7 * mm * std::cos(25 * degree),
              1e-15);
}

TEST(Geometry, AForgottenValueIsNamedWithItsRange) {
  EXPECT_THAT(refusal([](auto& g) { g.ball_count = 0; }),
              AllOf(HasSubstr("ball_count"), HasSubstr("missing"), HasSubstr("3")));
  EXPECT_THAT(refusal([](auto& g) { g.ball_diameter = unset; }),
              AllOf(HasSubstr("ball_diameter"), HasSubstr("missing"), HasSubstr("300 mm")));
  EXPECT_THAT(refusal([](auto& g) { g.pitch_diameter = unset; }),
              AllOf(HasSubstr("pitch_diameter"), HasSubstr("missing"), HasSubstr("mm")));
  EXPECT_THAT(refusal([](auto& g) { g.contact_angle = unset; }),
              AllOf(HasSubstr("contact_angle"), HasSubstr("missing"), HasSubstr("65 deg")));
  EXPECT_THAT(refusal([](auto& g) { g.inner_conformity = unset; }),
              AllOf(HasSubstr("inner_conformity"), HasSubstr("missing")));
  EXPECT_THAT(refusal([](auto& g) { g.outer_conformity = unset; }),
              AllOf(HasSubstr("outer_conformity"), HasSubstr("missing")));
}

TEST(Geometry, AnImpossibleValueIsNamedWithUnitAndRange) {
  EXPECT_THAT(refusal([](auto& g) { g.ball_diameter = -12.7 * mm; }),
              AllOf(HasSubstr("ball_diameter = -12.7 mm"), HasSubstr("0.1 to 300 mm")));
  EXPECT_THAT(refusal([](auto& g) { g.pitch_diameter = 0.0; }),
              AllOf(HasSubstr("pitch_diameter = 0 mm"), HasSubstr("5000 mm")));
  EXPECT_THAT(refusal([](auto& g) { g.contact_angle = 95 * degree; }),
              AllOf(HasSubstr("contact_angle = 95 deg"), HasSubstr("0 to 65 deg")));
  EXPECT_THAT(refusal([](auto& g) { g.inner_conformity = 0.5; }),
              AllOf(HasSubstr("inner_conformity = 0.5"), HasSubstr("0.5005 to 0.7")));
  EXPECT_THAT(refusal([](auto& g) { g.outer_conformity = 0.49; }),
              HasSubstr("outer_conformity = 0.49"));
  EXPECT_THAT(refusal([](auto& g) { g.ball_count = 1; }), HasSubstr("ball_count = 1"));
  EXPECT_THAT(refusal([](auto& g) { g.static_load_rating = -5; }),
              HasSubstr("static_load_rating = -5 N"));
  EXPECT_THAT(refusal([](auto& g) { g.bore = 200 * mm; }), HasSubstr("bore = 200 mm"));
  EXPECT_THAT(refusal([](auto& g) { g.outer_diameter = 80 * mm; }),
              HasSubstr("outer_diameter = 80 mm"));
  EXPECT_THAT(refusal([](auto& g) { g.ball_diameter = std::numeric_limits<double>::infinity(); }),
              HasSubstr("ball_diameter = inf"));
}

TEST(Geometry, MoreBallsThanFitAreRefused) {
  EXPECT_THAT(refusal([](auto& g) { g.ball_count = 23; }),
              AllOf(HasSubstr("ball_count = 23"), HasSubstr("at most 22"), HasSubstr("12.7 mm")));
  EXPECT_EQ(refusal([](auto& g) { g.ball_count = 22; }), "");
}

TEST(Geometry, ClearanceBelongsToDeepGroovesOnly) {
  EXPECT_THAT(refusal([](auto& g) { g.radial_clearance = 10 * um; }),
              AllOf(HasSubstr("radial_clearance = 10 um"), HasSubstr("contact_angle")));
  EXPECT_EQ(refusal([](auto& g) {
              g.contact_angle = 0.0;
              g.radial_clearance = 10 * um;
            }),
            "");
  EXPECT_THAT(refusal([](auto& g) {
                g.contact_angle = 0.0;
                g.radial_clearance = -10 * um;
              }),
              HasSubstr("radial_clearance = -10 um"));
}

TEST(Material, AnImpossibleValueIsNamedWithItsOwner) {
  Material m = steel();
  m.name = "my-ball";
  m.elastic_modulus = -1 * GPa;
  try {
    const Bearing bearing(good(), m, steel());
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("my-ball"), HasSubstr("elastic_modulus = -1 GPa")));
  }
  m = silicon_nitride();
  m.density = unset;
  EXPECT_THROW(Bearing(good(), m, steel()), std::invalid_argument);
}

TEST(Material, CatalogueValues) {
  EXPECT_DOUBLE_EQ(steel().elastic_modulus, 208e9);
  EXPECT_DOUBLE_EQ(steel().density, 7800);
  EXPECT_DOUBLE_EQ(silicon_nitride().elastic_modulus, 310e9);
  EXPECT_DOUBLE_EQ(silicon_nitride().density, 3200);
}

TEST(OperatingPoint, WhatIsNotFiniteOrTurnsBackwardsIsRefused) {
  EXPECT_NO_THROW(validate(OperatingPoint{}));
  EXPECT_THROW(validate(OperatingPoint{.speed = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(OperatingPoint{.axial_load = unset}), std::invalid_argument);
  EXPECT_THROW(validate(OperatingPoint{.radial_load = std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
}

TEST(Bearing, BallMassAndAzimuths) {
  const Bearing bearing(good(), steel(), steel());
  EXPECT_NEAR(bearing.ball_mass(), 7800 * pi / 6 * std::pow(12.7 * mm, 3), 1e-12);
  EXPECT_NEAR(bearing.ball_inertia(), 0.1 * bearing.ball_mass() * 12.7 * mm * 12.7 * mm, 1e-18);
  ASSERT_EQ(bearing.cos_azimuth().size(), 18u);
  EXPECT_EQ(bearing.cos_azimuth()[0], 1.0);
  EXPECT_GT(bearing.sin_azimuth()[1], 0.0);
}

}  // namespace
}  // namespace raceway::bearing
