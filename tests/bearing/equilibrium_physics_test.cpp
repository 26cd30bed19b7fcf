// What must hold for every bearing and load, over random cases with a fixed seed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bearing/bearing_equilibrium.h"
#include "tests/bearing/expect.h"
#include "tests/bearing/random_case.h"

namespace raceway::bearing {
namespace {

using tests::expect_relative;
using tests::random_cases;
using tests::SolvedCase;

/// Loads summed over the reported balls, in the order of the stiffness matrix.
Vector5 recovered_loads(const Bearing& bearing, const BearingEquilibrium& e) {
  const BearingGeometry& g = bearing.geometry();
  const double lever = g.inner_groove_centre_radius();
  Vector5 sum = Vector5::Zero();
  for (const BallEquilibrium& ball : e.balls) {
    if (std::isnan(ball.inner_contact_angle)) continue;
    const double s = std::sin(ball.inner_contact_angle), c = std::cos(ball.inner_contact_angle);
    const double axial = ball.inner_load * s + ball.inner_friction * c;
    const double radial = ball.inner_load * c - ball.inner_friction * s;
    // The friction acts at the race, f_i D away from the groove's centre.
    const double tilting =
        lever * axial - ball.inner_friction * g.inner_conformity * g.ball_diameter;
    sum[0] += axial;
    sum[1] += radial * std::cos(ball.azimuth);
    sum[2] += radial * std::sin(ball.azimuth);
    sum[3] += tilting * std::sin(ball.azimuth);
    sum[4] -= tilting * std::cos(ball.azimuth);
  }
  return sum;
}

OperatingPoint turned(const OperatingPoint& p, double angle) {
  OperatingPoint q = p;
  const double c = std::cos(angle), s = std::sin(angle);
  q.radial_load = c * p.radial_load - s * p.radial_load_z;
  q.radial_load_z = s * p.radial_load + c * p.radial_load_z;
  q.moment_y = c * p.moment_y - s * p.moment_z;
  q.moment_z = s * p.moment_y + c * p.moment_z;
  return q;
}

TEST(EquilibriumPhysics, RecoveredLoadsEqualTheApplied) {
  for (const SolvedCase& c : random_cases(300, 11)) {
    const Vector5 loads = recovered_loads(c.bearing, c.solved);
    const double scale = c.point.axial_load;
    EXPECT_NEAR(loads[0], c.point.axial_load, 1e-9 * scale);
    EXPECT_NEAR(loads[1], c.point.radial_load, 1e-9 * scale);
    EXPECT_NEAR(loads[2], c.point.radial_load_z, 1e-9 * scale);
    if (c.options.tilt == Tilt::free) {
      const double lever = c.bearing.geometry().inner_groove_centre_radius();
      EXPECT_NEAR(loads[3], c.point.moment_y, 1e-9 * scale * lever);
      EXPECT_NEAR(loads[4], c.point.moment_z, 1e-9 * scale * lever);
    }
    EXPECT_LE(c.solved.report.recovered_load_error, 1e-9);
  }
}

TEST(EquilibriumPhysics, EachBallIsInBalance) {
  for (const SolvedCase& c : random_cases(100, 12))
    for (const BallEquilibrium& b : c.solved.balls) {
      const double si = std::sin(b.inner_contact_angle), ci = std::cos(b.inner_contact_angle);
      const double so = std::sin(b.outer_contact_angle), co = std::cos(b.outer_contact_angle);
      const double tolerance = 1e-9 * (c.point.axial_load + b.outer_load);
      EXPECT_NEAR(b.inner_load * si + b.inner_friction * ci,
                  b.outer_load * so + b.outer_friction * co, tolerance);
      EXPECT_NEAR(b.inner_load * ci - b.inner_friction * si + b.centrifugal_force,
                  b.outer_load * co - b.outer_friction * so, tolerance);
      // M_g = J ω_m ω_R sin β, carried by the outer race alone: To = 2 M_g / D.
      expect_relative(b.outer_friction * c.bearing.geometry().ball_diameter / 2.0,
                      b.gyroscopic_moment, 1e-9);
    }
}

TEST(EquilibriumPhysics, AxialLoadLoadsAllBallsAlike) {
  for (SolvedCase c : random_cases(50, 13)) {
    c.point.radial_load = c.point.radial_load_z = 0.0;
    for (const Tilt tilt : {Tilt::locked, Tilt::free}) {
      c.options.tilt = tilt;
      const auto solved = c.solve_at(c.point);
      if (!solved.report.converged()) continue;
      for (const BallEquilibrium& ball : solved.balls) {
        expect_relative(ball.inner_load, solved.balls[0].inner_load, 1e-12);
        expect_relative(ball.outer_contact_angle, solved.balls[0].outer_contact_angle, 1e-12);
      }
      for (const int k : {1, 2, 3, 4}) EXPECT_NEAR(solved.displacement[k], 0.0, 1e-15);
    }
  }
}

TEST(EquilibriumPhysics, AMirroredLoadMirrorsTheSolution) {
  for (const SolvedCase& c : random_cases(50, 14)) {
    OperatingPoint mirrored = c.point;
    mirrored.radial_load_z = -c.point.radial_load_z;
    const auto other = c.solve_at(mirrored);
    ASSERT_TRUE(other.report.converged());
    const std::size_t count = c.solved.balls.size();
    for (std::size_t k = 0; k < count; ++k)
      expect_relative(other.balls[(count - k) % count].inner_load, c.solved.balls[k].inner_load,
                      1e-8);
    expect_relative(other.displacement[0], c.solved.displacement[0], 1e-8);
    EXPECT_NEAR(other.displacement[2], -c.solved.displacement[2], 1e-13);
    EXPECT_NEAR(other.displacement[3], -c.solved.displacement[3], 1e-11);
  }
}

TEST(EquilibriumPhysics, ALoadTurnedByABallPitchTurnsTheSolution) {
  for (const SolvedCase& c : random_cases(50, 15)) {
    const std::size_t count = c.solved.balls.size();
    const double pitch = 2.0 * pi / static_cast<double>(count);
    const auto other = c.solve_at(turned(c.point, pitch));
    ASSERT_TRUE(other.report.converged());
    for (std::size_t k = 0; k < count; ++k)
      expect_relative(other.balls[(k + 1) % count].inner_load, c.solved.balls[k].inner_load, 1e-8);
    expect_relative(other.displacement[0], c.solved.displacement[0], 1e-8);
    const double cosine = std::cos(pitch), sine = std::sin(pitch);
    for (const int k : {1, 3}) {
      const double y = c.solved.displacement[k], z = c.solved.displacement[k + 1];
      const double tolerance = k == 1 ? 1e-13 : 1e-11;
      EXPECT_NEAR(other.displacement[k], cosine * y - sine * z, tolerance);
      EXPECT_NEAR(other.displacement[k + 1], sine * y + cosine * z, tolerance);
    }
  }
}

// Change one load a little, solve again: the stiffness must turn the change of displacement back
// into the change of load.
TEST(EquilibriumPhysics, StiffnessEqualsTheDifferenceQuotientOfLoad) {
  for (const SolvedCase& c : random_cases(40, 16)) {
    const double lever = c.bearing.geometry().inner_groove_centre_radius();
    const std::array<double OperatingPoint::*, 5> loads{
        &OperatingPoint::axial_load, &OperatingPoint::radial_load, &OperatingPoint::radial_load_z,
        &OperatingPoint::moment_y, &OperatingPoint::moment_z};
    const int unknowns = c.options.tilt == Tilt::free ? 5 : 3;
    for (int column = 0; column < unknowns; ++column) {
      const double step = 1e-5 * c.point.axial_load * (column < 3 ? 1.0 : lever);
      OperatingPoint forward = c.point, backward = c.point;
      forward.*loads[static_cast<std::size_t>(column)] += step;
      backward.*loads[static_cast<std::size_t>(column)] -= step;
      const auto above = c.solve_at(forward), below = c.solve_at(backward);
      ASSERT_TRUE(above.report.converged() && below.report.converged());
      const Vector5 slope = (above.displacement - below.displacement) / (2.0 * step);
      const Vector5 change = c.solved.stiffness * slope;
      for (int row = 0; row < unknowns; ++row) {
        const double unit = (row < 3 ? 1.0 : lever) / (column < 3 ? 1.0 : lever);
        EXPECT_NEAR(change[row], row == column ? 1.0 : 0.0, 1e-5 * unit)
            << "row " << row << " column " << column;
      }
    }
  }
}

TEST(EquilibriumPhysics, BothRaceControlsAgreeAtRest) {
  for (SolvedCase c : random_cases(50, 17)) {
    c.point.speed = 1e-3;
    c.options.race_control = RaceControl::outer;
    const auto outer = c.solve_at(c.point);
    c.options.race_control = RaceControl::inner;
    const auto inner = c.solve_at(c.point);
    c.point.speed = 0.0;
    const auto rest = c.solve_at(c.point);
    ASSERT_EQ(outer.report.status, inner.report.status);
    if (!outer.report.converged()) continue;
    ASSERT_TRUE(rest.report.converged());
    for (int k = 0; k < 5; ++k) {
      const double scale = k < 3 ? 1 * um : 1 * mrad;
      EXPECT_NEAR(outer.displacement[k], inner.displacement[k], 1e-6 * scale);
      EXPECT_NEAR(outer.displacement[k], rest.displacement[k], 1e-6 * scale);
    }
  }
}

TEST(EquilibriumPhysics, AtRestInnerAndOuterAnglesAgree) {
  for (SolvedCase c : random_cases(100, 18)) {
    c.point.speed = 0.0;
    const auto solved = c.solve_at(c.point);
    if (!solved.report.converged()) continue;
    for (const BallEquilibrium& ball : solved.balls) {
      if (!(ball.inner_load > 0.0)) continue;
      EXPECT_NEAR(ball.inner_contact_angle, ball.outer_contact_angle, 1e-12);
      expect_relative(ball.inner_load, ball.outer_load, 1e-12);
      EXPECT_EQ(ball.centrifugal_force, 0.0);
      EXPECT_EQ(ball.gyroscopic_moment, 0.0);
    }
    EXPECT_TRUE(solved.stiffness.isApprox(solved.stiffness.transpose(), 1e-9));
  }
}

TEST(EquilibriumPhysics, SpeedRaisesTheInnerAndLowersTheOuterAngle) {
  for (SolvedCase c : random_cases(50, 19)) {
    c.point.radial_load = c.point.radial_load_z = 0.0;
    const auto fast = c.solve_at(c.point);
    c.point.speed *= 0.5;
    const auto slow = c.solve_at(c.point);
    if (!fast.report.converged() || !slow.report.converged()) continue;
    EXPECT_GT(fast.balls[0].inner_contact_angle, slow.balls[0].inner_contact_angle);
    EXPECT_LT(fast.balls[0].outer_contact_angle, slow.balls[0].outer_contact_angle);
    EXPECT_GT(fast.balls[0].outer_load, slow.balls[0].outer_load);
  }
}

TEST(EquilibriumPhysics, AWarmStartEndsAtTheColdStartsSolution) {
  for (const SolvedCase& c : random_cases(50, 20)) {
    OperatingPoint neighbour = c.point;
    neighbour.speed *= 0.97;
    neighbour.axial_load *= 1.03;
    const auto start = c.solve_at(neighbour);
    const auto warm = solve_bearing_equilibrium(c.bearing, c.point, c.options, start);
    ASSERT_TRUE(warm.report.converged());
    for (std::size_t k = 0; k < warm.balls.size(); ++k) {
      expect_relative(warm.balls[k].inner_load, c.solved.balls[k].inner_load, 1e-7);
      EXPECT_NEAR(warm.balls[k].outer_contact_angle, c.solved.balls[k].outer_contact_angle, 1e-9);
    }
  }
}

TEST(EquilibriumPhysics, WithoutBalanceThereIsAStatusAndNoNumber) {
  const SolvedCase c = random_cases(1, 21).at(0);
  for (const OperatingPoint& point :
       {OperatingPoint{}, OperatingPoint{.speed = 10000 * rpm}, OperatingPoint{.axial_load = -100},
        OperatingPoint{.speed = 10000 * rpm, .axial_load = -100},
        OperatingPoint{.speed = 10000 * rpm, .radial_load = 500}})
    for (const Tilt tilt : {Tilt::locked, Tilt::free}) {
      EquilibriumOptions options = c.options;
      options.tilt = tilt;
      const auto solved = solve_bearing_equilibrium(c.bearing, point, options);
      if (solved.report.converged()) {
        // A purely radial load with a free axial position can be carried; then it must be.
        EXPECT_NEAR(recovered_loads(c.bearing, solved)[1], point.radial_load, 1e-6);
        continue;
      }
      EXPECT_NE(solved.report.status, SolveStatus::not_run);
      EXPECT_TRUE(solved.displacement.array().isNaN().all());
      EXPECT_TRUE(solved.stiffness.array().isNaN().all());
      EXPECT_TRUE(solved.balls.empty());
    }
  const auto pulled =
      solve_bearing_equilibrium(c.bearing, {.speed = 10000 * rpm, .axial_load = -100}, c.options);
  EXPECT_EQ(pulled.report.status, SolveStatus::no_equilibrium);
  EXPECT_TRUE(pulled.report.certain);
}

// Inner control at light load and high speed: the search finds nothing, which proves nothing.
TEST(EquilibriumPhysics, AbsenceIsCertainOnlyWhereStaticsShowsIt) {
  const SolvedCase c = random_cases(1, 21).at(0);
  EXPECT_TRUE(solve_bearing_equilibrium(c.bearing, {.speed = 100.0}, c.options).report.certain);
  EquilibriumOptions inner = c.options;
  inner.race_control = RaceControl::inner;
  bool found_none = false;
  for (const double load : {0.01, 0.1, 1.0, 5.0}) {
    const BearingEquilibrium e = solve_bearing_equilibrium(
        c.bearing, {.speed = 20000 * rpm, .axial_load = load, .radial_load = 0.3 * load}, inner);
    found_none = found_none || e.report.status == SolveStatus::no_equilibrium;
    EXPECT_FALSE(e.report.certain);
  }
  EXPECT_TRUE(found_none);
}

TEST(EquilibriumPhysics, APointThatIsNotFiniteIsRefused) {
  const SolvedCase c = random_cases(1, 22).at(0);
  EXPECT_THROW((void)c.solve_at({.axial_load = unset}), std::invalid_argument);
  EXPECT_THROW((void)c.solve_at({.speed = -1.0, .axial_load = 100}), std::invalid_argument);
  EXPECT_THROW((void)c.solve_at({.axial_load = std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
}

TEST(EquilibriumPhysics, EveryStatusHasAName) {
  EXPECT_EQ(name(SolveStatus::converged), "converged");
  EXPECT_EQ(name(SolveStatus::no_equilibrium), "no_equilibrium");
  EXPECT_FALSE(SolveReport{}.converged());
}

}  // namespace
}  // namespace raceway::bearing
