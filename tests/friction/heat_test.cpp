#include "friction/heat.h"

#include <random>

#include "friction/friction_law.h"
#include "tests/friction/sample.h"

namespace raceway {
namespace {

using bearing::RaceControl;

struct Case {
  bearing::OperatingPoint point;
  RaceControl control;
};

std::vector<Case> random_cases(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> speed(0, 20000), axial(50, 6000), radial(0, 0.6);
  std::vector<Case> cases;
  for (int i = 0; i < count; ++i) {
    const double load = axial(random);
    cases.push_back(
        {{.speed = speed(random) * rpm, .axial_load = load, .radial_load = radial(random) * load},
         i % 2 == 0 ? RaceControl::outer : RaceControl::inner});
  }
  return cases;
}

TEST(Heat, InEqualsHeatOut) {
  const auto bearing = tests::spindle_bearing();
  int solved = 0;
  for (const Case& c : random_cases(100)) {
    const auto e = solve_bearing_equilibrium(bearing, c.point, {.race_control = c.control});
    if (!e.report.converged()) continue;
    ++solved;
    const auto s = tests::state_of(bearing, e, c.point, c.control);
    const std::array values{1.5, 0.001, 0.33};
    const auto base = base_moments<double>(friction::FrictionLaw::palmgren, s, values);
    const double mu = 0.06;
    const auto spin = friction::unit_spin_friction(bearing, e, c.control);
    const double moment = base.load + base.viscous + mu * (spin.inner + spin.outer);
    const auto heat = friction::split_heat(
        s, {.load = base.load, .viscous = base.viscous, .spin_coefficient = mu});
    tests::expect_relative(heat.inner + heat.outer, friction::power_loss(moment, s.speed), 1e-14);
    EXPECT_GE(heat.inner, 0.0);  // friction takes power and never gives it
    EXPECT_GE(heat.outer, 0.0);
  }
  EXPECT_GT(solved, 80);
}

TEST(Heat, OfSpinArisesAtTheContactThatSpins) {
  const auto bearing = tests::spindle_bearing();
  const bearing::OperatingPoint point{.speed = 8000 * rpm, .axial_load = 1500};
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
    const auto e = solve_bearing_equilibrium(bearing, point, {.race_control = control});
    ASSERT_TRUE(e.report.converged());
    const auto s = tests::state_of(bearing, e, point, control);
    const auto heat = friction::split_heat(s, {.spin_coefficient = 0.06});
    const auto speeds = e.speeds(0, bearing, point.speed, control);
    const auto power = [&](bearing::Race race, double load, double spin_speed) {
      return bearing.geometry().ball_count * 0.06 *
             friction::unit_spin_moment(bearing.contact(race), load) * spin_speed;
    };
    const double inner =
        power(bearing::Race::inner, e.balls[0].inner_load, speeds.inner_spin_speed);
    const double outer =
        power(bearing::Race::outer, e.balls[0].outer_load, speeds.outer_spin_speed);
    EXPECT_NEAR(heat.inner, inner, 1e-9 * (inner + outer));
    EXPECT_NEAR(heat.outer, outer, 1e-9 * (inner + outer));
  }
}

TEST(Heat, IsHalvedAtLowSpeedAndGoesToTheLoadedOuterRaceAtHighSpeed) {
  const auto bearing = tests::spindle_bearing();
  const auto inner_share = [&](double speed) {
    const bearing::OperatingPoint point{.speed = speed, .axial_load = 600};
    const auto e = solve_bearing_equilibrium(bearing, point);
    const auto heat =
        friction::split_heat(tests::state_of(bearing, e, point, RaceControl::outer), {.load = 0.1});
    return heat.inner / (heat.inner + heat.outer);
  };
  EXPECT_NEAR(inner_share(10 * rpm), 0.5, 1e-4);
  EXPECT_LT(inner_share(20000 * rpm), 0.3);
}

TEST(Heat, IsZeroAtStandstillAndUnknownWithoutBalance) {
  const auto bearing = tests::spindle_bearing();
  const bearing::OperatingPoint point{.axial_load = 600};
  const auto e = solve_bearing_equilibrium(bearing, point);
  auto s = tests::state_of(bearing, e, point, RaceControl::outer);
  const friction::HeatSources sources{.load = 0.1, .viscous = 0.2, .spin_coefficient = 0.06};
  EXPECT_EQ(friction::split_heat(s, sources).inner, 0.0);
  EXPECT_EQ(friction::split_heat(s, sources).outer, 0.0);
  s.equilibrium = nullptr;
  EXPECT_TRUE(std::isnan(friction::split_heat(s, sources).inner));
}

TEST(Heat, OfTheWholeBearingHasNoNumberOfBallsInIt) {
  EXPECT_DOUBLE_EQ(friction::power_loss(0.5, 1000.0), 500.0);
}

}  // namespace
}  // namespace raceway
