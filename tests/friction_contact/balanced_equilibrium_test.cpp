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
    off.holds((f.inner.sliding + f.outer.sliding) / N_mm, out.at("sliding_Nmm"), 1e-3, id);
    off.holds(f.moment() / N_mm, out.at("torque_Nmm"), 5e-4, id + " torque");
  }
}

}  // namespace
}  // namespace raceway::friction::contact
