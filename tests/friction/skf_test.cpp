#include "friction/skf.h"

#include "tests/friction/sample.h"
#include "tests/reference_table.h"

namespace raceway {
namespace {

using friction::BearingState;
using friction::RingSize;
using friction::SkfRolling;
using friction::SkfSliding;

TEST(Skf, MeetsTheTableOfAnAngularContactBearing) {
  bearing::BearingGeometry g = tests::spindle_geometry();
  g.bore = 70 * mm;
  g.outer_diameter = 110 * mm;
  const bearing::Bearing bearing(g, bearing::steel(), bearing::steel());
  const RingSize ring{g.bore, g.outer_diameter};
  for (const auto& row : tests::reference_table("skf_stribeck_7014.csv")) {
    SCOPED_TRACE(row.place());
    BearingState<double> s;
    s.bearing = &bearing;
    s.speed = row["speed_rpm"] * rpm;
    s.axial_load = row["axial_load_N"];
    s.kinematic_viscosity = 22 * mm2_per_s;
    const double nu = s.kinematic_viscosity, tolerance = row["relative_tolerance"];
    const double share = friction::boundary_share(s.speed, nu, ring.mean_diameter());
    tests::expect_relative(friction::inlet_shear_factor(s.speed, nu, ring.mean_diameter()),
                           row["inlet_shear_factor"], tolerance);
    tests::expect_relative(friction::replenishment_factor(6e-8, s.speed, nu, ring, 4.4),
                           row["replenishment_factor"], tolerance);
    tests::expect_relative(share, row["boundary_share"], tolerance);
    tests::expect_relative(friction::sliding_coefficient(0.15, 0.05, share),
                           row["sliding_coefficient"], tolerance);
    const double rolling = SkfRolling::moment(s, 6e-8);
    const double sliding = SkfSliding::moment(s, 0.15, 0.05);
    tests::expect_relative(rolling, row["rolling_moment_Nm"], tolerance);
    tests::expect_relative(sliding, row["sliding_moment_Nm"], tolerance);
    tests::expect_relative(rolling + sliding, row["moment_Nm"], tolerance);
  }
}

TEST(Skf, FactorsMeetTheWorkedExampleOfTheCatalogue) {
  for (const auto& row : tests::reference_table("skf_factors_22208E.csv")) {
    SCOPED_TRACE(row.place());
    const RingSize ring{row["bore_mm"] * mm, row["outer_diameter_mm"] * mm};
    const double speed = row["speed_rpm"] * rpm;
    const double nu = row["kinematic_viscosity_mm2_s"] * mm2_per_s;
    tests::expect_relative(friction::inlet_shear_factor(speed, nu, ring.mean_diameter()),
                           row["inlet_shear_factor"], row["relative_tolerance"]);
    tests::expect_relative(friction::replenishment_factor(row["K_rs"], speed, nu, ring, row["K_Z"]),
                           row["replenishment_factor"], row["relative_tolerance"]);
  }
}

TEST(Skf, CeramicBallsLowerTheCentrifugalPart) {
  const auto steel = tests::spindle_bearing();
  const auto hybrid = tests::spindle_bearing(bearing::silicon_nitride());
  BearingState<double> s;
  s.axial_load = 500;
  s.kinematic_viscosity = 22 * mm2_per_s;
  const auto sliding = [&](const bearing::Bearing& bearing, double speed) {
    s.bearing = &bearing;
    s.speed = speed;
    return SkfSliding::moment(s, 0.15, 0.05);
  };
  EXPECT_EQ(sliding(hybrid, 0.0), sliding(steel, 0.0));
  EXPECT_LT(sliding(hybrid, 20000 * rpm), sliding(steel, 20000 * rpm));
  // Far up only F_g counts, by its power 4/3.
  tests::expect_relative(sliding(hybrid, 1e7 * rpm) / sliding(steel, 1e7 * rpm),
                         std::pow(0.41, 4.0 / 3.0), 1e-6);
}

TEST(Skf, RollsWithoutMomentAtStandstillAndSlidesOnItsBoundaryFilm) {
  const auto bearing = tests::spindle_bearing();
  BearingState<double> s;
  s.bearing = &bearing;
  s.axial_load = 500;
  s.kinematic_viscosity = 22 * mm2_per_s;
  EXPECT_EQ(SkfRolling::moment(s, 6e-8), 0.0);
  const double boundary = SkfSliding::moment(s, 0.15, 0.05);
  EXPECT_GT(boundary, 0.0);
  EXPECT_EQ(SkfSliding::moment(s, 0.15, 0.1), boundary);
}

TEST(Skf, DerivativesAreThoseOfTheFormula) {
  const auto rolling = [](const auto& s, const auto& p) { return SkfRolling::moment(s, p[0]); };
  const auto sliding = [](const auto& s, const auto& p) {
    return SkfSliding::moment(s, p[0], p[1]);
  };
  const std::array rolling_values{6e-8};
  const std::array sliding_values{0.15, 0.05};
  const auto bearing = tests::spindle_bearing();
  for (const double speed : {300 * rpm, 8000 * rpm}) {
    const std::array inputs{speed, 700.0, 300.0, 22 * mm2_per_s};
    tests::expect_derivatives(bearing, inputs, rolling_values, rolling);
    tests::expect_derivatives(bearing, inputs, sliding_values, sliding);
  }
  tests::expect_finite_at_the_edges(bearing, rolling_values, rolling);
  tests::expect_finite_at_the_edges(bearing, sliding_values, sliding);
}

}  // namespace
}  // namespace raceway
