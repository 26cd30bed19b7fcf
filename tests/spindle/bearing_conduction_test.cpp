#include "spindle/bearing_conduction.h"

#include "bearing/bearing_equilibrium.h"
#include "spindle/contact.h"
#include "tests/spindle/case_bearing.h"
#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

using bearing::Race;

bearing::Bearing bearing_7014() {
  return {{.ball_count = 20,
           .ball_diameter = 11.9 * mm,
           .pitch_diameter = 90 * mm,
           .contact_angle = 15 * degree,
           .inner_conformity = 0.52,
           .outer_conformity = 0.52},
          bearing::steel(),
          bearing::steel()};
}

TEST(BearingConduction, IsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("bearing_conduction_")) {
    const BallConduction balls(*case_bearing(c.inputs.at("bearing")), c.in("lambda_ball"),
                               c.in("lambda_ring"));
    const double load = c.in("ball_load_N");
    c.holds("inner_K_W", balls.resistance(Race::inner, load));
    c.holds("outer_K_W", balls.resistance(Race::outer, load));
    c.holds("bearing_W_K", balls.conductance(load, load));
  }
}

TEST(BearingConduction, IsTheConstrictionOfTheEllipseAtEveryLoad) {
  const bearing::Bearing bearing = bearing_7014();
  const BallConduction balls(bearing, 30.0, 46.0);
  for (const Race race : {Race::inner, Race::outer})
    for (const double load : {0.1, 5.0, 50.0, 2000.0}) {
      const auto& contact = bearing.contact(race);
      const double direct = constriction_resistance(contact.semi_major_axis(load),
                                                    contact.semi_minor_axis(load), 30.0, 46.0);
      EXPECT_NEAR(balls.resistance(race, load), direct, 1e-11 * direct);
    }
}

// The formula as Thermca has it, over the speeds of its domain.
TEST(BearingConduction, UsualLubricantConductanceIsThatOfSchaefer) {
  for (const double diameter : {5 * mm, 11.9 * mm, 22 * mm})
    for (const double speed_factor : {2e5, 5e5, 2e6}) {  // n d_m [mm/min]
      const double pitch_speed = speed_factor * mm * rpm;
      const double printed = 590.0 * 20 * diameter * diameter *
                             std::sqrt(7.0 + std::log(pitch_speed / (2000.0 * diameter)));
      EXPECT_NEAR(usual_lubricant_conductance({.ball_count = 20, .ball_diameter = diameter}),
                  printed, 0.12 * printed);
    }
}

TEST(BearingConduction, NeedsBothRaces) {
  const BallConduction balls(bearing_7014(), 46.0, 46.0);
  EXPECT_EQ(balls.conductance(0.0, 0.0), 0.0);
  EXPECT_EQ(balls.conductance(0.0, 80.0), 0.0);
  EXPECT_EQ(balls.conductance(50.0, -1.0), 0.0);
  EXPECT_EQ(balls.conductance(unset, 50.0), 0.0);
  // In series: worse than either.
  const double one = balls.conductance(50.0, 80.0);
  EXPECT_LT(one, 20.0 / balls.resistance(Race::outer, 80.0));
  EXPECT_LT(one, 20.0 / balls.resistance(Race::inner, 50.0));
  // Grows with the cube root of the load.
  EXPECT_NEAR(balls.conductance(400.0, 640.0), 2.0 * one, 1e-12 * one);
}

TEST(BearingConduction, SumsUnevenBalls) {
  const bearing::Bearing bearing = bearing_7014();
  const BallConduction conduction(bearing, 46.0, 46.0);
  for (const double radial : {0.0, 300.0}) {
    const auto balance = bearing::solve_bearing_equilibrium(
        bearing, {.speed = 8000 * rpm, .axial_load = 400.0, .radial_load = radial});
    ASSERT_TRUE(balance.report.converged());
    double sum = 0.0;
    for (const bearing::BallEquilibrium& ball : balance.balls)
      sum += conduction.ball(ball.inner_load, ball.outer_load);
    EXPECT_NEAR(conduction.conductance(balance.balls), sum, 1e-12 * sum);
    if (radial == 0.0) {
      const auto& ball = balance.balls.distinct()[0];
      EXPECT_NEAR(conduction.conductance(ball.inner_load, ball.outer_load), sum, 1e-12 * sum);
    }
  }
}

}  // namespace
}  // namespace raceway::spindle
