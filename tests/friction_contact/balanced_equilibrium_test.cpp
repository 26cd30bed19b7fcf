#include "friction/contact/balanced_equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/friction_contact/balanced_cases.h"

namespace raceway::friction::contact {
namespace {

TEST(BalancedEquilibrium, IsThatOfTheReference) {
  Distance off("balanced");
  for (const auto& c : contact_cases("balanced_")) {
    const auto& out = c.at("outputs");
    const std::string id = c.at("id");
    const BalancedRun run(c.at("inputs"));
    const BalancedEquilibrium e = run.solve();
    ASSERT_TRUE(e.report.converged()) << id;
    const bearing::BallEquilibrium ball = e.equilibrium.balls[0];
    EXPECT_NEAR(e.equilibrium.displacement[0] / um, out.at("displacement_um"), 1e-3) << id;
    off.holds(ball.inner_contact_angle / degree, out.at("angle_inner_deg"), 1e-5, id + " αi");
    off.holds(ball.outer_contact_angle / degree, out.at("angle_outer_deg"), 1e-5, id + " αo");
    off.holds(ball.inner_load, out.at("Q_inner"), 1e-5, id + " Qi");
    off.holds(ball.outer_load, out.at("Q_outer"), 1e-5, id + " Qo");
    off.holds(e.attitudes[0].pitch_angle() / degree, out.at("beta_deg"), 5e-3, id + " pitch");
    const BearingFriction f = run.friction(e);
    EXPECT_TRUE(f.converged);
    off.holds((f.inner.sliding + f.outer.sliding) / N_mm, out.at("sliding_Nmm"), 4e-3, id);
    off.holds(f.moment() / N_mm, out.at("torque_Nmm"), 5e-4, id + " torque");
  }
}

TEST(BalancedEquilibrium, LosesNoPowerOverThirtySpeedsAndGoesSmoothly) {
  double angle = 0.0, slope = 0.0;
  for (int i = 0; i < 30; ++i) {
    const BalancedRun run = steel_7014(1000.0 * std::pow(20.0, i / 29.0));
    const BalancedEquilibrium e = run.solve();
    ASSERT_TRUE(e.report.converged()) << i;
    const BallAttitude& a = e.attitudes[0];
    EXPECT_NEAR((a.inner.power + a.outer.power) / a.shaft_power, 1.0, 1e-6) << i;
    const double now = e.equilibrium.balls[0].outer_contact_angle / degree;
    if (i > 1) {
      EXPECT_NEAR(now - angle, slope, 0.25) << i;
    }
    slope = now - angle;
    angle = now;
  }
}

TEST(BalancedEquilibrium, UnderBoundaryFrictionLiesBetweenTheRaceControls) {
  const BalancedRun run = steel_7014(10.0);
  const BalancedEquilibrium e = run.solve();
  ASSERT_TRUE(e.report.converged());
  const auto pitch = [&](bearing::RaceControl control) {
    const auto plain = solve_bearing_equilibrium(run.bearing, run.point, {.race_control = control});
    return plain.speeds(0, run.bearing, run.point.speed, control).pitch_angle;
  };
  EXPECT_GT(e.attitudes[0].pitch_angle(), pitch(bearing::RaceControl::outer));
  EXPECT_LT(e.attitudes[0].pitch_angle(), pitch(bearing::RaceControl::inner));
}

TEST(BalancedEquilibrium, AtStandstillIsTheLimitOfSlowRotation) {
  const BalancedRun still = steel_7014(0.0), slow = steel_7014(1e-4);
  const double moment = still.friction(still.solve()).moment();
  EXPECT_NEAR(slow.friction(slow.solve()).moment(), moment, 2e-3 * moment);
}

TEST(BalancedEquilibrium, DoesNotDependOnTheSignOfARadialLoad) {
  BalancedRun run = steel_7014(8000.0);
  run.point.radial_load = 100.0;
  const BalancedEquilibrium up = run.solve();
  run.point.radial_load = -100.0;
  const BalancedEquilibrium down = run.solve();
  ASSERT_TRUE(up.report.converged() && down.report.converged());
  EXPECT_NEAR(up.equilibrium.displacement[1], -down.equilibrium.displacement[1], 1e-12);
  EXPECT_NEAR(run.friction(up).moment(), run.friction(down).moment(),
              1e-7 * run.friction(up).moment());
}

}  // namespace
}  // namespace raceway::friction::contact
