#include "bearing/ball_equilibrium.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/bearing/expect.h"

namespace raceway::bearing {
namespace {

Bearing spindle_bearing() {
  return {{.ball_count = 18,
           .ball_diameter = 12.7 * mm,
           .pitch_diameter = 90 * mm,
           .contact_angle = 25 * degree,
           .inner_conformity = 0.525,
           .outer_conformity = 0.515},
          steel(),
          steel()};
}

/// Groove centres and a ball between them, a few micrometres into both races.
struct State {
  Plane groove_centre{0.04 * 12.7 * mm * std::sin(25 * degree) + 12 * um,
                      0.04 * 12.7 * mm* std::cos(25 * degree) + 3 * um};
  Plane ball_centre{0.015 * 12.7 * mm * std::sin(18 * degree) + 2 * um,
                    0.015 * 12.7 * mm* std::cos(18 * degree) + 5 * um};
};

constexpr double moment_arm_ratio = 0.14;

BallBalance balance_of(const BallConstants& c, const State& s, const GivenRotation* given) {
  return ball_balance(c, s.groove_centre, s.ball_centre, moment_arm_ratio, InnerContact::automatic,
                      given);
}

std::array<double, 5> values(const BallConstants& c, const State& s, const GivenRotation* given) {
  const BallBalance b = balance_of(c, s, given);
  return {b.imbalance.axial, b.imbalance.radial, b.force.axial, b.force.radial, b.moment_force};
}

/// Central difference of values() when one coordinate of the state moves.
std::array<double, 5> difference(const BallConstants& c, State s, Plane State::*point,
                                 double Plane::*coordinate, const GivenRotation* given) {
  const double step = 1e-10;
  (s.*point).*coordinate += step;
  const auto forward = values(c, s, given);
  (s.*point).*coordinate -= 2.0 * step;
  const auto backward = values(c, s, given);
  std::array<double, 5> slope;
  for (std::size_t k = 0; k < slope.size(); ++k)
    slope[k] = (forward[k] - backward[k]) / (2.0 * step);
  return slope;
}

void expect_derivatives(const BallConstants& c, const State& s,
                        const GivenRotation* given = nullptr) {
  const BallBalance b = balance_of(c, s, given);
  // Rounding of the forces over the step; stiffnesses are of order 1e7 N/m.
  const double tolerance = 200.0;
  const std::array coordinates{&Plane::axial, &Plane::radial};
  for (std::size_t column = 0; column < 2; ++column) {
    const auto by_groove = difference(c, s, &State::groove_centre, coordinates[column], given);
    const auto by_ball = difference(c, s, &State::ball_centre, coordinates[column], given);
    for (std::size_t row = 0; row < 2; ++row) {
      EXPECT_NEAR(b.r_a[2 * row + column], by_groove[row], tolerance);
      EXPECT_NEAR(b.r_x[2 * row + column], by_ball[row], tolerance);
    }
    for (std::size_t row = 0; row < 3; ++row) {
      EXPECT_NEAR(b.f_a[2 * row + column], by_groove[2 + row], tolerance);
      EXPECT_NEAR(b.f_x[2 * row + column], by_ball[2 + row], tolerance);
    }
  }
}

TEST(BallEquilibrium, DerivativesEqualTheDifferenceQuotient) {
  const Bearing bearing = spindle_bearing();
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner})
    for (const bool gyroscopic : {true, false})
      for (const double speed : {100 * rpm, 20000 * rpm}) {
        SCOPED_TRACE(speed / rpm);
        expect_derivatives(ball_constants(bearing, speed, control, gyroscopic), State{});
      }
}

TEST(BallEquilibrium, DerivativesHoldForAGivenRotation) {
  const BallConstants c = ball_constants(spindle_bearing(), 20000 * rpm, RaceControl::outer, true);
  const double load = balance_of(c, State{}, nullptr).inner_load;
  ASSERT_GT(load, 10.0);
  // Frictions as found, and growing where they were found under more load.
  for (const double found_at : {0.5 * load, 2.0 * load})
    for (const double pitch : {-5 * degree, 0.0, 12 * degree}) {
      SCOPED_TRACE(pitch / degree);
      const GivenRotation given{.cos_pitch = std::cos(pitch),
                                .sin_pitch = std::sin(pitch),
                                .creep = 2e-3,
                                .inner_friction = 3.0,
                                .outer_friction = 7.0,
                                .inner_load = found_at};
      expect_derivatives(c, State{}, &given);
    }
}

TEST(BallEquilibrium, DerivativesHoldWhereTheInnerRaceIsLost) {
  State s;
  s.groove_centre.radial -= 40 * um;
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
    const BallConstants c = ball_constants(spindle_bearing(), 20000 * rpm, control, true);
    const BallBalance b = ball_balance(c, s.groove_centre, s.ball_centre, moment_arm_ratio);
    ASSERT_LT(b.inner_approach, 0.0);
    EXPECT_EQ(b.inner_load, 0.0);
    EXPECT_EQ(b.force.axial, 0.0);
    EXPECT_EQ(b.force.radial, 0.0);
    expect_derivatives(c, s);
  }
}

TEST(BallEquilibrium, OuterFrictionHelpsTheOuterRaceToCarryTheThrust) {
  const BallConstants c = ball_constants(spindle_bearing(), 20000 * rpm, RaceControl::outer, true);
  const State s;
  const BallBalance with = ball_balance(c, s.groove_centre, s.ball_centre, 0.0);
  EXPECT_GT(with.outer_friction, 0.0);
  const BallBalance without =
      ball_balance(ball_constants(spindle_bearing(), 20000 * rpm, RaceControl::outer, false),
                   s.groove_centre, s.ball_centre, 0.0);
  EXPECT_LT(with.imbalance.axial, without.imbalance.axial);
}

TEST(BallEquilibrium, FrictionTimesDiameterIsTheGyroscopicMoment) {
  const Bearing bearing = spindle_bearing();
  const double speed = 15000 * rpm;
  const State s;
  const double inner = std::atan2(s.groove_centre.axial - s.ball_centre.axial,
                                  s.groove_centre.radial - s.ball_centre.radial);
  const double outer = std::atan2(s.ball_centre.axial, s.ball_centre.radial);
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
    const BallBalance b = ball_balance(ball_constants(bearing, speed, control, true),
                                       s.groove_centre, s.ball_centre, 0.0);
    const BallSpeeds v =
        ball_speeds(control, inner, outer, bearing.geometry().diameter_ratio(), speed);
    const double moment =
        bearing.ball_inertia() * v.cage_speed * v.ball_speed * std::sin(v.pitch_angle);
    // Half of the couple at each contact, with the ball's radius as lever: (Ti + To) D/2 = M_g.
    tests::expect_relative(
        (b.inner_friction + b.outer_friction) * bearing.geometry().ball_diameter / 2.0, moment,
        1e-12);
    tests::expect_relative(
        b.centrifugal,
        0.5 * bearing.ball_mass() * bearing.geometry().pitch_diameter * v.cage_speed * v.cage_speed,
        1e-12);
  }
}

TEST(BallEquilibrium, AtRestBothContactsAreSpringsInSeries) {
  const Bearing bearing = spindle_bearing();
  const BallConstants c = ball_constants(bearing, 0.0, RaceControl::outer, true);
  const Plane groove = State{}.groove_centre;
  const StaticBall ball = static_ball(c, groove);
  const double approach = bearing.contact(Race::inner).approach(ball.load) +
                          bearing.contact(Race::outer).approach(ball.load);
  EXPECT_NEAR(std::hypot(groove.axial, groove.radial),
              bearing.geometry().groove_centre_distance() + approach, 1e-15);
  EXPECT_NEAR(std::hypot(ball.force.axial, ball.force.radial), ball.load, 1e-9);
  const double step = 1e-9;
  const Plane forward = static_ball(c, {groove.axial + step, groove.radial}).force;
  const Plane backward = static_ball(c, {groove.axial - step, groove.radial}).force;
  EXPECT_NEAR(ball.f_a[0], (forward.axial - backward.axial) / (2.0 * step), 20.0);
  EXPECT_NEAR(ball.f_a[2], (forward.radial - backward.radial) / (2.0 * step), 20.0);
}

}  // namespace
}  // namespace raceway::bearing
