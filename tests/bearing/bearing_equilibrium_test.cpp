#include "bearing/bearing_equilibrium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tests/bearing/expect.h"
#include "tests/reference_table.h"

namespace raceway::bearing {
namespace {

using tests::expect_relative;
using tests::reference_table;
using tests::ReferenceRow;

Material material(const ReferenceRow& row) {
  return {.name = "reference",
          .elastic_modulus = row["elastic_modulus_Pa"],
          .poisson_ratio = row["poisson_ratio"],
          .density = 7800,
          .thermal_expansion = 11.5 * per_million_K};
}

Bearing angular_contact(const ReferenceRow& row) {
  return {{.ball_count = static_cast<int>(row["ball_count"]),
           .ball_diameter = row["ball_diameter_m"],
           .pitch_diameter = row["pitch_diameter_m"],
           .contact_angle = row["contact_angle_deg"] * degree,
           .inner_conformity = row["inner_conformity"],
           .outer_conformity = row["outer_conformity"]},
          material(row),
          material(row)};
}

template <typename Row>
Bearing deep_groove_bearing(const Row& row) {
  return {{.ball_count = static_cast<int>(row["ball_count"]),
           .ball_diameter = row["ball_diameter_m"],
           .pitch_diameter = row["pitch_diameter_m"],
           .contact_angle = 0.0,
           .inner_conformity = row["inner_conformity"],
           .outer_conformity = row["outer_conformity"],
           .radial_clearance = row["radial_clearance_m"]},
          material(row),
          material(row)};
}

TEST(BearingEquilibrium, DeepGrooveAtRestAgreesWithTheReferencePrograms) {
  for (const auto& row : reference_table("equilibrium_deep_groove.csv")) {
    SCOPED_TRACE(row.place());
    const Bearing bearing = deep_groove_bearing(row);
    const auto solved = solve_bearing_equilibrium(
        bearing, {.axial_load = row["axial_load_N"], .radial_load = row["radial_load_N"]});
    ASSERT_TRUE(solved.report.converged()) << name(solved.report.status);
    const double tolerance = row["relative_tolerance"];
    if (!row.text("axial_displacement_m").empty())
      expect_relative(solved.displacement[0], row["axial_displacement_m"], tolerance);
    if (!row.text("radial_displacement_m").empty())
      expect_relative(solved.displacement[1], row["radial_displacement_m"], tolerance);
    if (!row.text("largest_load_N").empty())
      expect_relative(solved.balls[0].inner_load, row["largest_load_N"], tolerance);
  }
}

// The source takes d_m/2 for the lever of tilt and moment and we R_i, so the same M/R has the same
// R θ.
TEST(BearingEquilibrium, AMomentAgreesWithTheReferenceProgram) {
  for (const auto& row : reference_table("equilibrium_moment.csv")) {
    SCOPED_TRACE(row.place());
    const Bearing bearing = deep_groove_bearing(row);
    const double lever =
        bearing.geometry().inner_groove_centre_radius() / (0.5 * row["pitch_diameter_m"]);
    const double tolerance = row["relative_tolerance"];
    const bool alone = row["axial_load_N"] == 0.0;
    for (const bool about_z : {false, true}) {
      if (about_z && !alone) continue;
      OperatingPoint point{.axial_load = row["axial_load_N"], .radial_load = row["radial_load_N"]};
      (about_z ? point.moment_z : point.moment_y) = row["moment_y_Nm"] * lever;
      const auto solved = solve_bearing_equilibrium(bearing, point, {.tilt = Tilt::free});
      ASSERT_TRUE(solved.report.converged()) << name(solved.report.status);
      const auto& u = solved.displacement;
      expect_relative(std::hypot(u[3], u[4]) * lever, row["tilt_rad"], tolerance);
      if (alone) continue;
      expect_relative(u[0], row["axial_displacement_m"], tolerance);
      expect_relative(std::hypot(u[1], u[2]), row["radial_displacement_m"], tolerance);
    }
  }
}

TEST(BearingEquilibrium, StaticThrustAgreesWithTheIndependentSolver) {
  for (const auto& row : reference_table("equilibrium_static_thrust.csv")) {
    SCOPED_TRACE(row.place());
    const double diameter = row["ball_diameter_m"];
    const Bearing bearing({.ball_count = static_cast<int>(row["ball_count"]),
                           .ball_diameter = diameter,
                           .pitch_diameter = row["pitch_diameter_m"],
                           .contact_angle = row["contact_angle_rad"],
                           .inner_conformity = row["inner_groove_radius_m"] / diameter,
                           .outer_conformity = row["outer_groove_radius_m"] / diameter},
                          material(row), material(row));
    const auto solved = solve_bearing_equilibrium(bearing, {.axial_load = row["axial_load_N"]});
    ASSERT_TRUE(solved.report.converged()) << name(solved.report.status);
    const double tolerance = row["relative_tolerance"];
    expect_relative(solved.displacement[0], row["axial_displacement_m"], tolerance);
    expect_relative(solved.stiffness(0, 0), row["axial_stiffness_N_m"], tolerance);
    expect_relative(solved.stiffness(1, 1), row["radial_stiffness_N_m"], tolerance);
    for (const BallEquilibrium& ball : solved.balls) {
      expect_relative(ball.inner_contact_angle, row["running_contact_angle_rad"], tolerance);
      expect_relative(ball.outer_contact_angle, row["running_contact_angle_rad"], tolerance);
      expect_relative(ball.inner_load, row["contact_load_N"], tolerance);
    }
  }
}

TEST(BearingEquilibrium, StaticThrustIsNearTheRoundedNumbersOfTheBook) {
  for (const auto& row : reference_table("equilibrium_218_book.csv")) {
    SCOPED_TRACE(row.place());
    const double conformity = (1.0 + row["total_curvature"]) / 2.0;
    const Bearing bearing({.ball_count = static_cast<int>(row["ball_count"]),
                           .ball_diameter = row["ball_diameter_m"],
                           .pitch_diameter = row["pitch_diameter_m"],
                           .contact_angle = row["contact_angle_deg"] * degree,
                           .inner_conformity = conformity,
                           .outer_conformity = conformity},
                          material(row), material(row));
    const auto solved = solve_bearing_equilibrium(bearing, {.axial_load = row["axial_load_N"]});
    ASSERT_TRUE(solved.report.converged()) << name(solved.report.status);
    EXPECT_NEAR(solved.balls[0].inner_contact_angle / degree, row["running_contact_angle_deg"],
                row["angle_tolerance_deg"]);
    expect_relative(solved.balls[0].inner_load, row["contact_load_N"],
                    row["load_relative_tolerance"]);
    expect_relative(solved.displacement[0], row["axial_displacement_m"],
                    row["displacement_relative_tolerance"]);
  }
}

TEST(BearingEquilibrium, RotatingThrustAgreesWithTheIndependentSolver) {
  for (const auto& row : reference_table("equilibrium_rotating_thrust.csv")) {
    SCOPED_TRACE(row.place() + " " + row.text("id"));
    const Bearing bearing = angular_contact(row);
    const double speed = row["speed_rpm"] * rpm;
    const auto solved =
        solve_bearing_equilibrium(bearing, {.speed = speed, .axial_load = row["axial_load_N"]},
                                  {.gyroscopic_moment = row.text("gyroscopic_moment") == "with"});
    ASSERT_TRUE(solved.report.converged()) << name(solved.report.status);
    const double tolerance = row["relative_tolerance"];
    expect_relative(solved.displacement[0], row["axial_displacement_m"], tolerance);
    const double stiffness_tolerance = row["stiffness_relative_tolerance"];
    expect_relative(solved.stiffness(0, 0), row["axial_stiffness_N_m"], stiffness_tolerance);
    expect_relative(solved.stiffness(1, 1), row["radial_stiffness_N_m"], stiffness_tolerance);
    expect_relative(solved.stiffness(4, 4), row["tilt_stiffness_Nm_rad"], stiffness_tolerance);
    const BallEquilibrium& ball = solved.balls[7];
    expect_relative(ball.inner_contact_angle / degree, row["inner_contact_angle_deg"], tolerance);
    expect_relative(ball.outer_contact_angle / degree, row["outer_contact_angle_deg"], tolerance);
    expect_relative(ball.inner_load, row["inner_load_N"], tolerance);
    expect_relative(ball.outer_load, row["outer_load_N"], tolerance);
    expect_relative(ball.centrifugal_force, row["centrifugal_force_N"], tolerance);
    expect_relative(ball.gyroscopic_moment, row["gyroscopic_moment_Nm"], tolerance);
    const BallSpeeds speeds = solved.speeds(7, bearing, speed, RaceControl::outer);
    expect_relative(speeds.cage_speed, row["cage_speed_rad_s"], tolerance);
    expect_relative(speeds.ball_speed, row["ball_speed_rad_s"], tolerance);
    expect_relative(speeds.pitch_angle, row["pitch_angle_rad"], tolerance);
  }
}

// The source's stiffnesses are numerical; this pins ours beyond their sixth digit.
TEST(BearingEquilibrium, StiffnessOfRotatingThrustIsTheSlopeOfTheLoad) {
  for (const auto& row : reference_table("equilibrium_rotating_thrust.csv")) {
    SCOPED_TRACE(row.place() + " " + row.text("id"));
    const Bearing bearing = angular_contact(row);
    const EquilibriumOptions options{.gyroscopic_moment = row.text("gyroscopic_moment") == "with"};
    const double load = row["axial_load_N"];
    const auto displacement = [&](double axial_load, double radial_load) -> Vector5 {
      const auto solved = solve_bearing_equilibrium(
          bearing,
          {.speed = row["speed_rpm"] * rpm, .axial_load = axial_load, .radial_load = radial_load},
          options);
      EXPECT_TRUE(solved.report.converged());
      return solved.displacement;
    };
    const auto solved = solve_bearing_equilibrium(
        bearing, {.speed = row["speed_rpm"] * rpm, .axial_load = load}, options);
    const double step = 1e-5 * load;
    const double axial = displacement(load + step, 0.0)[0] - displacement(load - step, 0.0)[0];
    expect_relative(solved.stiffness(0, 0), 2.0 * step / axial, 1e-7);
    expect_relative(solved.stiffness(1, 1), step / displacement(load, step)[1], 1e-7);
  }
}

TEST(BearingEquilibrium, GyroscopicMomentLowersTheOuterAngle) {
  const Bearing bearing({.ball_count = 18,
                         .ball_diameter = 12.7 * mm,
                         .pitch_diameter = 90 * mm,
                         .contact_angle = 25 * degree,
                         .inner_conformity = 0.525,
                         .outer_conformity = 0.515},
                        {.name = "reference",
                         .elastic_modulus = 206 * GPa,
                         .poisson_ratio = 0.3,
                         .density = 7800,
                         .thermal_expansion = 11.5 * per_million_K},
                        {.name = "reference",
                         .elastic_modulus = 206 * GPa,
                         .poisson_ratio = 0.3,
                         .density = 7800,
                         .thermal_expansion = 11.5 * per_million_K});
  const OperatingPoint point{.speed = 20000 * rpm, .axial_load = 1000};
  const auto angle = [&](bool gyroscopic) {
    const auto solved =
        solve_bearing_equilibrium(bearing, point, {.gyroscopic_moment = gyroscopic});
    return solved.balls.at(0).outer_contact_angle / degree;
  };
  // The wrong sign would give 10.73.
  EXPECT_NEAR(angle(true), 5.35, 0.005);
  EXPECT_NEAR(angle(false), 7.17, 0.005);
}

struct Combined {
  Bearing bearing;
  OperatingPoint point;
  BearingEquilibrium solved;
};

std::map<std::string, Combined> solve_combined() {
  std::map<std::string, Combined> cases;
  for (const auto& row : reference_table("equilibrium_combined.csv")) {
    const Bearing bearing = angular_contact(row);
    const OperatingPoint point{.speed = row["speed_rpm"] * rpm,
                               .axial_load = row["axial_load_N"],
                               .radial_load = row["radial_load_N"]};
    const Tilt tilt = row.text("tilt") == "free" ? Tilt::free : Tilt::locked;
    cases.emplace(
        row.text("id"),
        Combined{bearing, point, solve_bearing_equilibrium(bearing, point, {.tilt = tilt})});
  }
  return cases;
}

TEST(BearingEquilibrium, CombinedLoadAgreesWithTheIndependentSolver) {
  const auto cases = solve_combined();
  for (const auto& row : reference_table("equilibrium_combined.csv")) {
    SCOPED_TRACE(row.text("id"));
    const auto& [bearing, point, solved] = cases.at(row.text("id"));
    ASSERT_TRUE(solved.report.converged()) << name(solved.report.status);
    const double tolerance = row["relative_tolerance"];
    expect_relative(solved.displacement[0], row["axial_displacement_m"], tolerance);
    expect_relative(solved.displacement[1], row["radial_displacement_m"], tolerance);
    EXPECT_NEAR(solved.displacement[2], 0.0, 1e-15);
    EXPECT_NEAR(solved.displacement[3], row["tilt_s_rad"], 1e-12);
    EXPECT_NEAR(-solved.displacement[4], row["tilt_c_rad"],
                tolerance * std::abs(row["tilt_c_rad"]));
    double moment = 0.0;
    for (const BallEquilibrium& ball : solved.balls)
      moment += bearing.geometry().inner_groove_centre_radius() * ball.inner_load *
                std::sin(ball.inner_contact_angle) * std::cos(ball.azimuth);
    EXPECT_NEAR(moment, row["reaction_moment_c_Nm"],
                tolerance * std::max(1.0, std::abs(row["reaction_moment_c_Nm"])));
  }
}

TEST(BearingEquilibrium, EachBallOfTheCombinedLoadAgrees) {
  const auto cases = solve_combined();
  for (const auto& row : reference_table("equilibrium_combined_balls.csv")) {
    SCOPED_TRACE(row.place());
    const auto& [bearing, point, solved] = cases.at(row.text("id"));
    const double tolerance = row["relative_tolerance"];
    const auto k = static_cast<std::size_t>(row["ball"]);
    const BallEquilibrium& ball = solved.balls.at(k);
    expect_relative(ball.inner_contact_angle, row["inner_contact_angle_rad"], tolerance);
    expect_relative(ball.outer_contact_angle, row["outer_contact_angle_rad"], tolerance);
    expect_relative(ball.inner_load, row["inner_load_N"], tolerance);
    expect_relative(ball.outer_load, row["outer_load_N"], tolerance);
    expect_relative(ball.centrifugal_force, row["centrifugal_force_N"], tolerance);
    expect_relative(ball.gyroscopic_moment, row["gyroscopic_moment_Nm"], tolerance);
    const BallSpeeds speeds = solved.speeds(k, bearing, point.speed, RaceControl::outer);
    expect_relative(speeds.cage_speed, row["cage_speed_rad_s"], tolerance);
    expect_relative(speeds.ball_speed, row["ball_speed_rad_s"], tolerance);
    expect_relative(speeds.pitch_angle, row["pitch_angle_rad"], tolerance);
  }
}

TEST(BearingEquilibrium, StiffnessOfTheCombinedLoadAgrees) {
  const auto cases = solve_combined();
  const std::array<std::string, 5> names{"x", "y", "z", "c", "s"};
  // tilt_s = theta_y, tilt_c = -theta_z
  const std::array<int, 5> index{0, 1, 2, 4, 3};
  const std::array<double, 5> sign{1.0, 1.0, 1.0, -1.0, 1.0};
  for (const auto& row : reference_table("equilibrium_combined_stiffness.csv")) {
    SCOPED_TRACE(row.place());
    const Matrix5& k = cases.at(row.text("id")).solved.stiffness;
    const auto r = static_cast<std::size_t>(std::find(names.begin(), names.end(), row.text("row")) -
                                            names.begin());
    for (std::size_t c = 0; c < names.size(); ++c) {
      const double value = sign[r] * sign[c] * k(index[r], index[c]);
      const double scale = std::sqrt(k(index[r], index[r]) * k(index[c], index[c]));
      EXPECT_NEAR(value, row["column_" + names[c]], row["relative_tolerance"] * scale) << names[c];
    }
  }
}

}  // namespace
}  // namespace raceway::bearing
