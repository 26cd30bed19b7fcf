#include "friction/contact/balanced_equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/bearing/random_case.h"
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

/// What traction takes from the shaft, and what is lost at the contacts [W].
std::pair<double, double> powers(const BalancedEquilibrium& e) {
  double taken = 0.0, lost = 0.0;
  for (std::size_t k = 0; k < e.attitudes.size(); ++k) {
    if (!(e.equilibrium.balls.distinct()[k].inner_load > 0.0)) continue;
    const double weight = e.equilibrium.balls.weight(k);
    taken += weight * e.attitudes[k].shaft_power;
    lost += weight * (e.attitudes[k].inner.power + e.attitudes[k].outer.power);
  }
  return {taken, lost};
}

TEST(BalancedEquilibrium, IsFoundInRandomStatesAndAgainFromANeighbour) {
  const BalancedRun oil = steel_7014(1000.0);
  const auto sizes = tests::catalogue_sizes();
  int asked = 0, found = 0;
  for (std::uint64_t index = 0; index < 300; ++index) {
    SCOPED_TRACE(index);
    const auto c = robustness::make_case(sizes, bearing::RaceControl::outer, 5, index);
    const bearing::Bearing bearing(
        c.geometry, index % 3 ? bearing::steel() : bearing::silicon_nitride(), bearing::steel());
    if (!solve_bearing_equilibrium(bearing, c.point, c.options).report.converged()) continue;
    ++asked;
    const auto e = solve_balanced_equilibrium(bearing, c.point, oil.oil, oil.law, c.options);
    if (!e.report.converged()) continue;
    ++found;
    const auto [taken, lost] = powers(e);
    EXPECT_NEAR(lost, taken, 1e-5 * taken);
    if (index % 10 != 0) continue;
    bearing::OperatingPoint near = c.point;
    near.speed *= 0.99;
    const auto neighbour = solve_balanced_equilibrium(bearing, near, oil.oil, oil.law, c.options);
    const auto again = solve_balanced_equilibrium(bearing, c.point, oil.oil, oil.law, c.options,
                                                  &neighbour.equilibrium);
    if (!neighbour.report.converged() || !again.report.converged()) continue;
    EXPECT_NEAR(again.equilibrium.displacement[0], e.equilibrium.displacement[0], 1e-10);
  }
  EXPECT_GT(asked, 290);
  EXPECT_GE(found, 0.99 * asked);
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
