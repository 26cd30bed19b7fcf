#include "friction/palmgren.h"

#include <random>

#include "tests/friction/sample.h"
#include "tests/reference_table.h"

namespace raceway {
namespace {

using friction::BearingState;
using friction::PalmgrenLoad;
using friction::PalmgrenViscous;

bearing::Bearing bearing_of(double pitch_diameter, double contact_angle, double rating) {
  bearing::BearingGeometry g = tests::spindle_geometry();
  g.ball_count = 8;
  g.ball_diameter = pitch_diameter / 8.0;
  g.pitch_diameter = pitch_diameter;
  g.contact_angle = contact_angle;
  g.static_load_rating = rating;
  return {g, bearing::steel(), bearing::steel()};
}

void expect_viscous_reference(const std::string& file) {
  for (const auto& row : tests::reference_table(file)) {
    SCOPED_TRACE(row.place());
    const auto bearing = bearing_of(row["pitch_diameter_mm"] * mm, 25 * degree, 43000);
    BearingState<double> s;
    s.bearing = &bearing;
    s.speed = row["speed_rpm"] * rpm;
    s.kinematic_viscosity = row["kinematic_viscosity_mm2_s"] * mm2_per_s;
    tests::expect_relative(PalmgrenViscous::moment(s, row["f0"]) / N_mm, row["moment_Nmm"],
                           row["relative_tolerance"]);
  }
}

TEST(PalmgrenViscous, MeetsTheReference) { expect_viscous_reference("palmgren_viscous.csv"); }

TEST(PalmgrenViscous, MeetsTheExampleOfTheCatalogue) {
  expect_viscous_reference("palmgren_krw_6220.csv");
}

TEST(PalmgrenLoad, MeetsTheReference) {
  for (const auto& row : tests::reference_table("palmgren_load.csv")) {
    SCOPED_TRACE(row.place());
    const auto bearing = bearing_of(row["pitch_diameter_mm"] * mm,
                                    row["contact_angle_deg"] * degree, row["static_load_rating_N"]);
    BearingState<double> s;
    s.bearing = &bearing;
    s.axial_load = row["axial_load_N"];
    s.radial_load = row["radial_load_N"];
    tests::expect_relative(PalmgrenLoad::moment(s, row["z"], row["y"]) / N_mm, row["moment_Nmm"],
                           row["relative_tolerance"]);
  }
}

TEST(PalmgrenViscous, HasItsPlateauDownToStandstill) {
  const auto bearing = tests::spindle_bearing();
  BearingState<double> s;
  s.bearing = &bearing;
  s.kinematic_viscosity = 20 * mm2_per_s;
  const double still = PalmgrenViscous::moment(s, 2.0);
  s.speed = 99.9 * rpm;
  EXPECT_EQ(PalmgrenViscous::moment(s, 2.0), still);
  s.speed = 100.1 * rpm;  // 0.8 % down, as printed
  tests::expect_relative(PalmgrenViscous::moment(s, 2.0), still * 158.74 / 160.0, 1e-3);
}

TEST(PalmgrenLoad, IsZeroWithoutLoadAndNeverNegative) {
  const auto bearing = tests::spindle_bearing();
  BearingState<double> s;
  s.bearing = &bearing;
  EXPECT_EQ(PalmgrenLoad::moment(s, 0.001, 0.33), 0.0);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> load(-5000, 5000);
  for (int i = 0; i < 1000; ++i) {
    s.axial_load = load(random);
    s.radial_load = std::abs(load(random));
    EXPECT_GT(PalmgrenLoad::moment(s, 0.001, 0.33), 0.0);
  }
}

TEST(PalmgrenLoad, AnUnknownLoadStaysUnknown) {
  const auto bearing = tests::spindle_bearing();
  BearingState<double> s;
  s.bearing = &bearing;
  s.axial_load = unset;
  s.radial_load = 100;
  EXPECT_TRUE(std::isnan(PalmgrenLoad::moment(s, 0.001, 0.33)));
}

TEST(Palmgren, DerivativesAreThoseOfTheFormula) {
  const auto bearing = tests::spindle_bearing();
  const auto load = [](const auto& s, const auto& p) {
    return PalmgrenLoad::moment(s, p[0], p[1]);
  };
  const auto viscous = [](const auto& s, const auto& p) {
    return PalmgrenViscous::moment(s, p[0]);
  };
  const std::array load_values{0.001, 0.33};
  const std::array viscous_values{1.5};
  for (const double radial : {0.0, 300.0, 4000.0}) {
    const std::array inputs{8000 * rpm, 700.0, radial, 22 * mm2_per_s};
    tests::expect_derivatives(bearing, inputs, load_values, load);
    tests::expect_derivatives(bearing, inputs, viscous_values, viscous);
  }
  tests::expect_finite_at_the_edges(bearing, load_values, load);
  tests::expect_finite_at_the_edges(bearing, viscous_values, viscous);
}

}  // namespace
}  // namespace raceway
