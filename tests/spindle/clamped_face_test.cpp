#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "spindle/spindle.h"
#include "tests/spindle/base_spindle.h"

// Side faces of rings under the clamping force of nut and cover.
namespace raceway::spindle {
namespace {

struct SteadySpindle {
  Moment moment;
  std::vector<SurfaceState> surfaces;
  [[nodiscard]] const SurfaceState& at(const std::string& name) const {
    for (const SurfaceState& s : surfaces)
      if (s.name == name) return s;
    throw std::out_of_range(name);
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const SurfaceState& s : surfaces) list.push_back(s.name);
    return list;
  }
};

SteadySpindle steady_of(const model::Model& m) {
  Simulator simulator(m);
  Report report;
  SteadySpindle now{.moment = simulator.steady({.speed = 6000 * rpm}, report), .surfaces = {}};
  EXPECT_TRUE(report.converged()) << report.message;
  now.surfaces = simulator.surfaces();
  return now;
}

model::Model clamped(double inner_force) {
  model::Model m = base_spindle();
  m.spindle->seat.inner_clamping_force = inner_force;
  return m;
}

/// The base spindle whose shaft stands up between the front bearings: all inner rings stand against
/// shoulders of the shaft, and there is no spacer.
model::Model without_spacer(double inner_force = unset) {
  model::Model m = clamped(inner_force);
  const auto piece = [](double length, double diameter) {
    return model::Segment{.length = length * mm, .diameter = diameter * mm, .bore = 36 * mm};
  };
  m.spindle->shaft.segments = {piece(50, 104), piece(20, 70), piece(10, 82), piece(20, 70),
                               piece(180, 82), piece(20, 70), piece(75, 60)};
  return m;
}

// Faces from 70 to 82 mm have 1432.57 mm²: 8000 N press with 5.584 MPa. Brecher et al. 2021, eq. 4,
// with Ra 0.8 µm, slope 0.15 and 3 GPa between 42 and 46 W/(m K) gives 25 866 W/(m² K), the air of
// 3 Ra adds 11 250. Between two rings of 46 W/(m K), the spots conduct 27 098.
TEST(ClampedFace, ConductsByThePressureOfItsForce) {
  const SteadySpindle now = steady_of(clamped(8000.0));
  const SurfaceState& shoulder = now.at("front_1_inner_front");
  EXPECT_NEAR(shoulder.area, 1432.57e-6, 0.01e-6);
  EXPECT_NEAR(shoulder.pressure, 5.5844 * MPa, 0.0001 * MPa);
  EXPECT_NEAR(shoulder.conductance, 37116.2, 2.0);
  const SurfaceState& spacer = now.at("front_1_inner_rear");
  EXPECT_NEAR(spacer.area, 1432.57e-6, 0.01e-6);
  EXPECT_NEAR(spacer.conductance, 38347.9, 2.0);
  EXPECT_THAT(now.names(), testing::IsSupersetOf({"front_2_inner_front", "front_2_inner_rear",
                                                  "rear_1_inner_front"}));
  // Behind the rear bearing the shaft is thinner; its outer ring stands free.
  EXPECT_THAT(now.names(), testing::Not(testing::Contains("rear_1_inner_rear")));
  // A collar that turns against an outer ring is not clamped.
  EXPECT_EQ(now.at("collars").conductance, 8000.0);
  EXPECT_NEAR(now.moment.heat.stored, 0.0, 1e-2);
}

TEST(ClampedFace, OfEqualShouldersIsThatOfTheirCommonConductance) {
  const SteadySpindle forced = steady_of(without_spacer(8000.0));
  model::Model given = without_spacer();
  given.spindle->seat.shoulder_conductance = forced.at("front_1_inner_front").conductance;
  const SteadySpindle same = steady_of(given);
  EXPECT_NEAR(forced.moment.displacement, same.moment.displacement,
              1e-9 * same.moment.displacement);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(forced.moment.bearings[k].inner_ring_temperature,
                same.moment.bearings[k].inner_ring_temperature, 1e-7);
  EXPECT_THAT(forced.names(), testing::Not(testing::Contains("shoulders")));
  EXPECT_THAT(same.names(), testing::Contains("shoulders"));
}

TEST(ClampedFace, LessForceLeavesTheRingHotter) {
  const SteadySpindle loose = steady_of(without_spacer(50.0)),
                      tight = steady_of(without_spacer(8000.0));
  EXPECT_LT(loose.at("front_1_inner_front").conductance,
            tight.at("front_1_inner_front").conductance);
  const double in_loose = loose.moment.bearings[0].inner_ring_temperature,
               in_tight = tight.moment.bearings[0].inner_ring_temperature;
  EXPECT_GT(in_loose - in_tight, 0.01);
  EXPECT_LT(in_loose - in_tight, 5.0);
}

// The heat of a face flows from the ring into its shoulder: the ring is the source of it.
TEST(ClampedFace, CarriesHeatFromTheRing) {
  const SteadySpindle now = steady_of(without_spacer(8000.0));
  EXPECT_GT(now.at("front_1_inner_front").heat, 1.0);
  EXPECT_GT(now.at("rear_1_inner_front").heat, 1.0);
}

TEST(ClampedFace, OfAnOuterRingConductsIntoTheHousing) {
  model::Model m = base_spindle();
  m.spindle->seat.outer_clamping_force = 5000.0;
  m.spindle->housing.segments = {{.length = 10 * mm,
                                  .diameter = 180 * mm,
                                  .bore = 105 * mm,
                                  .material = model::iron_of_housings},
                                 {.length = 265 * mm,
                                  .diameter = 180 * mm,
                                  .bore = unset,
                                  .material = model::iron_of_housings}};
  const SteadySpindle now = steady_of(m);
  const SurfaceState& face = now.at("front_1_outer_front");
  const double area = 0.25 * pi * (0.110 * 0.110 - 0.105 * 0.105);
  EXPECT_NEAR(face.area, area, 1e-9);
  EXPECT_NEAR(face.pressure, 5000.0 / area, 1.0);
  const double spots =
      std::pow(5000.0 / area / 3e9, 0.93) * 0.15 / (0.46 * 0.8e-6 * (1.0 / 46.0 + 1.0 / 48.0));
  EXPECT_NEAR(face.conductance, spots + 0.027 / 2.4e-6, 1e-6 * spots);
  // The inner rings keep their shoulders.
  EXPECT_EQ(now.at("shoulders").conductance, 8000.0);
}

TEST(ClampedFace, BetweenTwoRingsIsNamedOnce) {
  model::Model m = clamped(8000.0);
  m.spindle->seat.outer_clamping_force = 5000.0;
  m.spindle->front_positions = {60 * mm, 80 * mm};
  const std::vector<std::string> names = steady_of(m).names();
  for (const char* once : {"front_1_inner_rear", "front_1_outer_rear"})
    EXPECT_EQ(std::count(names.begin(), names.end(), once), 1) << once;
  EXPECT_THAT(names, testing::Not(testing::Contains("front_2_inner_front")));
  EXPECT_THAT(names, testing::Not(testing::Contains("front_2_outer_front")));
}

}  // namespace
}  // namespace raceway::spindle
