#include "bearing/displaced_bearing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace raceway::bearing {
namespace {

Bearing spindle_7014(double angle) {
  return Bearing({.ball_count = 20,
                  .ball_diameter = 11.9 * mm,
                  .pitch_diameter = 90 * mm,
                  .contact_angle = angle * degree,
                  .inner_conformity = 0.52,
                  .outer_conformity = 0.52},
                 steel(), steel());
}

TEST(DisplacedBearing, CarriesTheLoadThatMakesItsDisplacement) {
  const Bearing bearing = spindle_7014(15.0);
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner})
    for (const double speed : {0.0, 3000.0, 12000.0}) {
      EquilibriumOptions options;
      options.tilt = Tilt::free;
      options.race_control = control;
      const OperatingPoint point{.speed = speed * rpm,
                                 .axial_load = 900.0,
                                 .radial_load = 250.0,
                                 .radial_load_z = -80.0,
                                 .moment_y = 1.5,
                                 .moment_z = 4.0};
      const BearingEquilibrium e = solve_bearing_equilibrium(bearing, point, options);
      ASSERT_TRUE(e.report.converged());
      DisplacedBearing held(bearing, point.speed, {}, options);
      ASSERT_TRUE(held.hold(e.displacement));
      const double expected[] = {900.0, 250.0, -80.0, 1.5, 4.0};
      for (int i = 0; i < 5; ++i) EXPECT_NEAR(held.force()[i], expected[i], 1e-6) << i;
      EXPECT_LT((held.stiffness() - e.stiffness).norm(), 1e-7 * e.stiffness.norm());
      EXPECT_NEAR(held.equilibrium().balls[3].inner_load, e.balls[3].inner_load, 1e-6);
    }
}

TEST(DisplacedBearing, StiffnessIsTheDifferenceQuotientOfForce) {
  const Bearing bearing = spindle_7014(25.0);
  const RingShift shift{
      .axial = 1 * um, .radial = 3 * um, .inner_length = 0.2 * um, .outer_length = -0.1 * um};
  for (const double speed : {0.0, 8000.0}) {
    DisplacedBearing held(bearing, speed * rpm, shift);
    Vector5 place;
    place << 12 * um, 3 * um, -2 * um, 2e-5, -4e-5;
    ASSERT_TRUE(held.hold(place));
    const Matrix5 k = held.stiffness();
    for (int j = 0; j < 5; ++j) {
      const double step = j < 3 ? 1e-9 : 2e-8;
      Vector5 ahead = place, behind = place;
      ahead[j] += step;
      behind[j] -= step;
      ASSERT_TRUE(held.hold(ahead));
      const Vector5 more = held.force();
      ASSERT_TRUE(held.hold(behind));
      const Vector5 quotient = (more - held.force()) / (2.0 * step);
      for (int i = 0; i < 5; ++i) {
        const double scale = std::sqrt(k(i, i) * k(j, j));
        EXPECT_NEAR(quotient[i], k(i, j), 1e-5 * scale) << i << j;
      }
    }
  }
}

TEST(DisplacedBearing, RingsThatHaveComeApartTouchNothing) {
  const Bearing bearing = spindle_7014(15.0);
  for (const double speed : {0.0, 6000.0}) {
    DisplacedBearing held(bearing, speed * rpm);
    Vector5 place = Vector5::Zero();
    place[0] = -300 * um;
    ASSERT_TRUE(held.hold(place));
    EXPECT_EQ(held.force().norm(), 0.0);
    EXPECT_EQ(held.equilibrium().lost_balls(), 20);
  }
}

TEST(DisplacedBearing, InASetItIsAsStiffAsTheSetSays) {
  const auto bearing = std::make_shared<const Bearing>(spindle_7014(15.0));
  const Arrangement set({.front = {{bearing}, {bearing, 1 * um}},
                         .rear = {{bearing}},
                         .preload = PreloadForce{300.0}});
  ArrangementCondition condition{.speed = 6000 * rpm, .elongation = 20 * um};
  for (const double warm : {14.0, 16.0, 18.0})
    condition.shifts.push_back(thermal_shift(*bearing,
                                             {.inner_ring = kelvin(20 + warm),
                                              .outer_ring = kelvin(24),
                                              .balls = unset,
                                              .shaft = kelvin(20),
                                              .housing = kelvin(20)},
                                             kelvin(20)));
  const ArrangementEquilibrium e = solve_arrangement(set, condition);
  ASSERT_TRUE(e.report.converged());
  const auto whole = bearings_in_set(set, condition, e);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(whole[i].stiffness(0, 0), e.bearings[i].axial_stiffness,
                1e-7 * e.bearings[i].axial_stiffness);
    EXPECT_NEAR(whole[i].displacement[0], e.bearings[i].displacement, 1e-15);
    EXPECT_NEAR(whole[i].balls[0].inner_load, e.bearings[i].ball.inner_load, 1e-6);
    EXPECT_NEAR(whole[i].stiffness(1, 1), whole[i].stiffness(2, 2),
                1e-9 * whole[i].stiffness(1, 1));
  }
}

}  // namespace
}  // namespace raceway::bearing
