#include "bearing/frequencies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::bearing {
namespace {

Bearing rolling_bearing() {
  return {{.ball_count = 18,
           .ball_diameter = 12.7 * mm,
           .pitch_diameter = 90 * mm,
           .contact_angle = 25 * degree,
           .inner_conformity = 0.525,
           .outer_conformity = 0.515},
          steel(),
          steel()};
}

TEST(Frequencies, OfACatalogueAreTheFourFormulas) {
  // Z = 9, D/d_m cos α = 0.2: cage 0.4, outer 3.6, inner 5.4.
  const BearingGeometry g{.ball_count = 9,
                          .ball_diameter = 10 * mm,
                          .pitch_diameter = 50 * mm,
                          .contact_angle = 0.0,
                          .inner_conformity = 0.52,
                          .outer_conformity = 0.52};
  const BearingFrequencies f = nominal_frequencies(g, 0.0);
  EXPECT_DOUBLE_EQ(f.cage, 0.4);
  EXPECT_DOUBLE_EQ(f.outer_race, 3.6);
  EXPECT_DOUBLE_EQ(f.inner_race, 5.4);
  EXPECT_DOUBLE_EQ(f.ball_spin, 2.4);
}

TEST(Frequencies, OfBothRacesAddUpToTheBalls) {
  const Bearing bearing = rolling_bearing();
  for (const double n : {10.0, 5000.0, 20000.0})
    for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
      const auto solved = solve_bearing_equilibrium(
          bearing, {.speed = n * rpm, .axial_load = 1000.0, .radial_load = 200.0},
          {.race_control = control});
      ASSERT_TRUE(solved.report.converged()) << n;
      const BearingFrequencies f = running_frequencies(bearing, solved, control);
      EXPECT_NEAR(f.outer_race + f.inner_race, 18.0, 1e-12);
      EXPECT_NEAR(f.outer_race, 18.0 * f.cage, 1e-12);
    }
}

TEST(Frequencies, AtLowSpeedAreThoseOfTheRunningContactAngle) {
  const Bearing bearing = rolling_bearing();
  const auto solved = solve_bearing_equilibrium(bearing, {.axial_load = 500.0});
  const BearingFrequencies running = running_frequencies(bearing, solved, RaceControl::outer);
  const BearingFrequencies nominal =
      nominal_frequencies(bearing.geometry(), solved.balls[0].inner_contact_angle);
  EXPECT_NEAR(running.cage, nominal.cage, 1e-12);
  // The ball turns about an axis that is not quite across the contact.
  const BallSpeeds v = solved.speeds(0, bearing, 1.0, RaceControl::outer);
  const double tilt = v.pitch_angle - solved.balls[0].outer_contact_angle;
  EXPECT_NEAR(running.ball_spin * std::cos(tilt), nominal.ball_spin, 1e-9 * nominal.ball_spin);
}

TEST(Frequencies, AreNoNumbersWithoutABalance) {
  EXPECT_TRUE(std::isnan(running_frequencies(rolling_bearing(), {}, RaceControl::outer).cage));
}

}  // namespace
}  // namespace raceway::bearing
