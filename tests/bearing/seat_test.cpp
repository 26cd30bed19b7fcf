#include "bearing/seat.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/bearing/random_case.h"

namespace raceway::bearing {
namespace {

/// Catalogue bearings at speed, their axial load laid on as something else.
robustness::Case loaded_case(RaceControl control, std::uint64_t index) {
  static const auto sizes = tests::catalogue_sizes();
  auto c = robustness::make_case(sizes, control, 11, index);
  c.point.radial_load = c.point.radial_load_z = 0.0;
  return c;
}

int carrying(const BearingEquilibrium& e) {
  int count = 0;
  for (const BallEquilibrium& b : e.balls) count += b.inner_load > 0.0;
  return count;
}

// With a shoulder on one side only all axial pushes have one sign, and without axial load they
// vanish one by one. Where tilt is free one ball alone leaves the ring to pivot about it.
TEST(Seat, ARadialLoadAloneIsCarriedAtTheBottomOfTheGrooves) {
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
    int free = 0;
    for (std::uint64_t index = 0; index < 100; ++index) {
      SCOPED_TRACE(index);
      auto c = loaded_case(control, index);
      c.point.radial_load = c.point.axial_load;
      c.point.axial_load = 0.0;
      c.options.tilt = Tilt::locked;
      const Bearing bearing(c.geometry, steel(), steel());
      const auto e = solve_bearing_equilibrium(bearing, c.point, c.options);
      ASSERT_TRUE(e.report.converged()) << name(e.report.status);
      EXPECT_EQ(seat(e, c.geometry), Seat::groove_bottom);
      const double back = c.geometry.groove_centre_distance() * std::sin(c.geometry.contact_angle);
      EXPECT_NEAR(e.displacement[0], -back, 1e-9 * back);
      for (const BallEquilibrium& b : e.balls)
        if (b.inner_load > 0.0) {
          EXPECT_NEAR(b.inner_contact_angle, 0.0, 1e-9);
        }
      c.options.tilt = Tilt::free;
      const auto tilting = solve_bearing_equilibrium(bearing, c.point, c.options);
      free += tilting.report.converged();
      if (carrying(e) > 1) {
        ASSERT_TRUE(tilting.report.converged()) << name(tilting.report.status);
        EXPECT_NEAR(tilting.displacement[1], e.displacement[1], 1e-6 * e.displacement[1]);
      } else {
        EXPECT_EQ(tilting.report.status, SolveStatus::singular);
      }
    }
    EXPECT_GT(free, 80);
  }
}

// The state without axial load is the limit of little of it, and is named alike.
TEST(Seat, ALittleAxialLoadChangesAPureRadialLoadALittle) {
  for (std::uint64_t index = 0; index < 30; ++index) {
    SCOPED_TRACE(index);
    auto c = loaded_case(RaceControl::outer, index);
    c.options.tilt = Tilt::locked;
    const double load = c.point.axial_load;
    c.point.radial_load = load;
    const Bearing bearing(c.geometry, steel(), steel());
    c.point.axial_load = 0.0;
    const auto none = solve_bearing_equilibrium(bearing, c.point, c.options);
    c.point.axial_load = 1e-4 * load;
    const auto little = solve_bearing_equilibrium(bearing, c.point, c.options);
    ASSERT_TRUE(little.report.converged());
    EXPECT_EQ(seat(little, c.geometry), Seat::groove_bottom);
    EXPECT_NEAR(little.displacement[0] * none.stiffness(0, 0),
                none.displacement[0] * none.stiffness(0, 0) + c.point.axial_load,
                0.02 * c.point.axial_load);
    c.point.axial_load = load;
    const auto seated = solve_bearing_equilibrium(bearing, c.point, c.options);
    ASSERT_TRUE(seated.report.converged());
    EXPECT_EQ(seat(seated, c.geometry), Seat::shoulder);
  }
}

// A moment so small that two balls carry it leaves the ring to pivot about these: three cases of a
// hundred at most.
TEST(Seat, AMomentAloneNeedsTheSideWithoutShoulder) {
  int carried = 0;
  for (std::uint64_t index = 0; index < 100; ++index) {
    SCOPED_TRACE(index);
    auto c = loaded_case(RaceControl::outer, index);
    (index % 2 ? c.point.moment_y : c.point.moment_z) =
        0.25 * c.point.axial_load * c.geometry.pitch_diameter;
    c.point.axial_load = 0.0;
    c.options.tilt = Tilt::free;
    const Bearing bearing(c.geometry, steel(), steel());
    const auto e = solve_bearing_equilibrium(bearing, c.point, c.options);
    carried += e.report.converged();
    if (e.report.converged()) {
      EXPECT_EQ(seat(e, c.geometry), Seat::far_side);
    }
    c.point.moment_y *= 10.0;
    c.point.moment_z *= 10.0;
    const auto more = solve_bearing_equilibrium(bearing, c.point, c.options);
    ASSERT_TRUE(more.report.converged()) << name(more.report.status);
    EXPECT_EQ(seat(more, c.geometry), Seat::far_side);
  }
  EXPECT_GE(carried, 97);
}

TEST(Seat, HalfTheCircleIsPressedByTheLoadThatTheIntegralsSay) {
  // Rigid rings, the contact angle held: Q = cos^1.5 ψ over half the circle.
  double axial = 0.0, radial = 0.0;
  constexpr int points = 20000;
  for (int i = 0; i < points; ++i) {
    const double psi = pi * ((i + 0.5) / points - 0.5), load = std::pow(std::cos(psi), 1.5);
    axial += load;
    radial += load * std::cos(psi);
  }
  EXPECT_NEAR(seating_load(100.0, 15.0 * degree), 100.0 * std::tan(15.0 * degree) * axial / radial,
              2e-4 * 100.0);
}

TEST(Seat, ADeepGrooveBearingIsAlwaysSeated) {
  EXPECT_EQ(seat(-0.1, 0.1, 0.0), Seat::shoulder);
  EXPECT_EQ(seat(0.0, 0.0, 0.0), Seat::shoulder);
}

}  // namespace
}  // namespace raceway::bearing
