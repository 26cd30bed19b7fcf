#include "bearing/hertz.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "record/units.h"
#include "tests/bearing/expect.h"
#include "tests/reference_table.h"

namespace raceway::bearing {
namespace {

using tests::expect_relative;
using tests::reference_table;

Material material(double elastic_modulus, double poisson_ratio) {
  return {.name = "test",
          .elastic_modulus = elastic_modulus,
          .poisson_ratio = poisson_ratio,
          .density = 7800,
          .thermal_expansion = 11.5 * per_million_K};
}

HertzContact circular(double radius) {
  const Material m = material(206 * GPa, 0.3);
  return hertz_contact({.sum = 2.0 / radius, .difference = 0.0}, m, m);
}

TEST(Hertz, GrooveContactsAgreeWithTheIndependentEvaluation) {
  for (const auto& row : reference_table("hertz_contact.csv")) {
    SCOPED_TRACE(row.place());
    const double tolerance = row["relative_tolerance"];
    const BearingGeometry geometry{.ball_count = 16,
                                   .ball_diameter = row["ball_diameter_m"],
                                   .pitch_diameter = row["pitch_diameter_m"],
                                   .contact_angle = row["contact_angle_rad"],
                                   .inner_conformity = row["conformity"],
                                   .outer_conformity = row["conformity"]};
    const Race race = row.text("race") == "inner" ? Race::inner : Race::outer;
    const Material m = material(row["elastic_modulus_Pa"], row["poisson_ratio"]);
    const Curvature curvature = groove_curvature(geometry, race, geometry.contact_angle);
    expect_relative(curvature.sum, row["curvature_sum_per_m"], tolerance);
    expect_relative(curvature.difference, row["curvature_difference"], tolerance);
    const HertzContact contact = hertz_contact(curvature, m, m);
    expect_relative(contact.ellipse_ratio, row["ellipse_ratio"], tolerance);
    expect_relative(contact.first_integral, row["first_integral"], tolerance);
    expect_relative(contact.second_integral, row["second_integral"], tolerance);
    expect_relative(contact.contact_stiffness, row["contact_stiffness_N_m1_5"], tolerance);
    const double load = row["load_N"];
    expect_relative(contact.approach(load), row["approach_m"], tolerance);
    expect_relative(contact.semi_major_axis(load), row["semi_major_axis_m"], tolerance);
    expect_relative(contact.semi_minor_axis(load), row["semi_minor_axis_m"], tolerance);
    expect_relative(contact.peak_pressure(load), row["peak_pressure_Pa"], tolerance);
    // The dimensionless factors, taken back from the dimensional results.
    const double s = std::cbrt(1.5 * load / (contact.contact_modulus * row["curvature_sum_per_m"]));
    expect_relative(contact.semi_major_axis(load) / s, row["a_star"], tolerance);
    expect_relative(contact.semi_minor_axis(load) / s, row["b_star"], tolerance);
    expect_relative(2.0 * contact.approach(load) / (s * s * row["curvature_sum_per_m"]),
                    row["delta_star"], tolerance);
  }
}

TEST(Hertz, SphereOnPlaneIsTheCircularLimit) {
  for (const auto& row : reference_table("hertz_sphere_plane.csv")) {
    SCOPED_TRACE(row.place());
    const double tolerance = row["relative_tolerance"];
    const Material m = material(row["elastic_modulus_Pa"], row["poisson_ratio"]);
    const HertzContact contact =
        hertz_contact({.sum = 2.0 / row["radius_m"], .difference = 0.0}, m, m);
    const double load = row["load_N"];
    expect_relative(contact.semi_major_axis(load), row["contact_radius_m"], tolerance);
    expect_relative(contact.semi_minor_axis(load), row["contact_radius_m"], tolerance);
    expect_relative(contact.approach(load), row["approach_m"], tolerance);
    expect_relative(contact.peak_pressure(load), row["peak_pressure_Pa"], tolerance);
  }
}

TEST(Hertz, EllipseIsExactWhereTheSimplifiedFormulasAreNot) {
  const Material m = material(206 * GPa, 0.3);
  for (const auto& row : reference_table("hertz_ellipse.csv")) {
    SCOPED_TRACE(row.place());
    const double tolerance = row["relative_tolerance"];
    const double ratio = row["radius_ratio"];
    const HertzContact contact =
        hertz_contact({.sum = 100.0, .difference = (ratio - 1.0) / (ratio + 1.0)}, m, m);
    expect_relative(contact.ellipse_ratio, row["ellipse_ratio"], tolerance);
    expect_relative(contact.second_integral, row["second_integral"], tolerance);
    expect_relative(contact.first_integral, row["first_integral"], tolerance);
    EXPECT_NEAR(1.0339 * std::pow(ratio, 0.636) / contact.ellipse_ratio - 1.0,
                row["simplified_ratio_error"], tolerance);
    EXPECT_NEAR((1.0003 + 0.5968 / ratio) / contact.second_integral - 1.0,
                row["simplified_second_error"], tolerance);
    EXPECT_NEAR((1.5277 + 0.6023 * std::log(ratio)) / contact.first_integral - 1.0,
                row["simplified_first_error"], tolerance);
  }
}

TEST(Hertz, LoadGrowsWithTheThreeHalvesPowerOfApproach) {
  const HertzContact contact = circular(5 * mm);
  for (const double approach : {0.01 * um, 1 * um, 30 * um})
    expect_relative(contact.load(4.0 * approach), 8.0 * contact.load(approach), 1e-14);
}

TEST(Hertz, ApproachAndLoadAreInverse) {
  const HertzContact contact = circular(5 * mm);
  for (const double load : {1e-3, 1.0, 1e4})
    expect_relative(contact.load(contact.approach(load)), load, 1e-13);
}

TEST(Hertz, SeparatedBodiesCarryNoLoad) {
  const HertzContact contact = circular(5 * mm);
  EXPECT_EQ(contact.load(0.0), 0.0);
  EXPECT_EQ(contact.load(-1 * um), 0.0);
  EXPECT_EQ(contact.peak_pressure(0.0), 0.0);
}

TEST(Hertz, PressureOverTheEllipseCarriesTheLoad) {
  const Material m = material(206 * GPa, 0.3);
  for (const double difference : {0.0, 0.3, 0.9, 0.99}) {
    const HertzContact contact = hertz_contact({.sum = 150.0, .difference = difference}, m, m);
    const double load = 700.0;
    expect_relative(2.0 / 3.0 * pi * contact.peak_pressure(load) * contact.semi_major_axis(load) *
                        contact.semi_minor_axis(load),
                    load, 1e-13);
  }
}

TEST(Hertz, NearlyCircularContactsAreContinuous) {
  const Material m = material(206 * GPa, 0.3);
  const double stiffness = circular(5 * mm).contact_stiffness;
  for (const double difference : {1e-13, 1e-11, 1e-9, 1e-7, 1e-6, 2e-6}) {
    const HertzContact contact =
        hertz_contact({.sum = 2.0 / (5 * mm), .difference = difference}, m, m);
    // Stiffness leaves the circle with the square of the difference, the axis ratio linearly.
    expect_relative(contact.contact_stiffness, stiffness, 1e-9);
    EXPECT_NEAR(contact.ellipse_ratio, 1.0 + 4.0 / 3.0 * difference, 1e-8);
  }
}

TEST(Hertz, AContactOutsideTheDomainIsRefused) {
  const Material m = material(206 * GPa, 0.3);
  for (const Curvature& curvature :
       {Curvature{.sum = 100.0, .difference = 1.0}, Curvature{.sum = 100.0, .difference = -0.1},
        Curvature{.sum = 0.0, .difference = 0.5}, Curvature{}})
    EXPECT_THROW((void)hertz_contact(curvature, m, m), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::bearing
