#include "friction/contact/ball_attitude.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/friction_contact/balanced_cases.h"

namespace raceway::friction::contact {
namespace {

double energy_error(const BallAttitude& a) {
  return (a.inner.power + a.outer.power) / a.shaft_power - 1.0;
}

TEST(BallAttitude, IsThatOfTheReferenceUnderItsLoads) {
  Distance off("attitude");
  for (const auto& c : contact_cases("balanced_")) {
    const auto& out = c.at("outputs");
    const BalancedRun run(c.at("inputs"));
    const double speed = run.point.speed;
    bearing::BallEquilibrium ball;
    ball.inner_contact_angle = out.at("angle_inner_deg").get<double>() * degree;
    ball.outer_contact_angle = out.at("angle_outer_deg").get<double>() * degree;
    ball.inner_load = out.at("Q_inner");
    ball.outer_load = out.at("Q_outer");
    const BallAttitude a = BallAttitudes(run.bearing, speed, run.oil, run.law).solve(ball);
    const std::string id = c.at("id");
    ASSERT_TRUE(a.report.converged()) << id;
    off.holds(a.pitch_angle() / degree, out.at("beta_deg"), 5e-3, id + " pitch");
    off.holds(a.cage_speed / speed, out.at("cage_ratio"), 1e-5, id + " cage");
    off.holds(a.ball_speed() / speed, out.at("w_R_ratio"), 1e-4,
              id + " ball speed");  // by the points
    off.holds(a.orbital / speed, out.at("w_T_ratio"), 5e-3, id + " orbital", 1e-4);
    off.holds(a.inner_force, out.at("T_inner_N"), 5e-3, id + " T_i", 0.01);
    off.holds(a.outer_force, out.at("T_outer_N"), 5e-3, id + " T_o", 0.01);
    EXPECT_LT(std::abs(energy_error(a)), 1e-8) << id;
  }
}

}  // namespace
}  // namespace raceway::friction::contact
