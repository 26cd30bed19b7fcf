// A spindle whose bearings are heated by a friction table.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/prediction.h"
#include "spindle/spindle.h"
#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

/// The torque of the spindle's law on a grid, as `raceway table` makes it, with a band of 5 %.
model::Model by_table(const model::Model& by_law, const friction::TableAxes& axes) {
  model::Model alone = by_law;
  alone.shaft.reset();
  alone.spindle.reset();
  auto table = std::make_shared<friction::TorqueTable>();
  table->file = "t.csv";
  table->grid = friction::build_stribeck_table(axes, {}, [&](auto points, auto results) {
    for (std::size_t i = 0; i < points.size(); ++i)
      results[i].friction_moment = predict_friction(alone, points[i]).torque;
  });
  table->band = table->grid;
  for (double& moment : table->band.friction_moment) moment *= 0.05;
  model::Model model = by_law;
  model.law = friction::FrictionLaw::table;
  model.law_values = {1.0};
  model.table = std::move(table);
  return model;
}

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(from + (to - from) * k / (count - 1));
  return values;
}

const friction::TableAxes fine{.speed = evenly(0.0, 8000 * rpm, 33),
                               .axial_load = evenly(100.0, 1500.0, 29),
                               .radial_load = {0.0},
                               .temperature = evenly(kelvin(15), kelvin(75), 25)};

TEST(SpindleByTable, HasTheTemperaturesOfTheLawThatMadeTheTable) {
  const model::Model by_law = base_spindle();
  Simulator law(by_law), table(by_table(by_law, fine));
  for (const double speed : {2000.0, 5300.0, 6000.0}) {
    Report of_law, of_table;
    const Moment a = law.steady({.speed = speed * rpm}, of_law);
    const Moment b = table.steady({.speed = speed * rpm}, of_table);
    ASSERT_TRUE(of_law.converged() && of_table.converged());
    ASSERT_EQ(a.bearings.size(), b.bearings.size());
    // Between points of the grid the torque differs by 0.05 % at most.
    EXPECT_NEAR(b.heat.friction, a.heat.friction, 5e-4 * a.heat.friction);
    for (std::size_t k = 0; k < a.bearings.size(); ++k) {
      const double rise = a.bearings[k].inner_ring_temperature - kelvin(20);
      EXPECT_NEAR(b.bearings[k].inner_ring_temperature, a.bearings[k].inner_ring_temperature,
                  5e-4 * rise);
      EXPECT_NEAR(b.bearings[k].power_band, 0.05 * b.bearings[k].power, 1e-3 * b.bearings[k].power);
    }
    EXPECT_NEAR(b.displacement, a.displacement, 1e-3 * std::abs(a.displacement));
    EXPECT_NEAR(b.heat.friction_band, 0.05 * b.heat.friction, 1e-3 * b.heat.friction);
    EXPECT_EQ(a.heat.friction_band, 0.0);
  }
}

TEST(SpindleByTable, FollowsTheLawOverTime) {
  const model::Model by_law = base_spindle();
  std::vector<ProfileRow> profile;
  for (int k = 1; k <= 60; ++k)
    profile.push_back({.time = 60.0 * k, .inputs = {.speed = (k <= 40 ? 5300 : 1700) * rpm}});
  const auto a = Simulator(by_law).simulate(profile);
  const auto b = Simulator(by_table(by_law, fine)).simulate(profile);
  ASSERT_TRUE(a.report.converged() && b.report.converged());
  for (std::size_t k = 0; k < profile.size(); ++k)
    EXPECT_NEAR(b.moments[k].bearings[0].inner_ring_temperature,
                a.moments[k].bearings[0].inner_ring_temperature, 0.05);
}

TEST(SpindleByTable, ScaleScalesItsHeat) {
  model::Model model = by_table(base_spindle(), fine);
  Report report;
  const double once = Simulator(model).steady({.speed = 4000 * rpm}, report).heat.friction;
  model.law_values = {1.2};
  const double more = Simulator(model).steady({.speed = 4000 * rpm}, report).heat.friction;
  // A warmer oil takes a part of it back.
  EXPECT_GT(more, 1.1 * once);
  EXPECT_LT(more, 1.2 * once);
}

}  // namespace
}  // namespace raceway::spindle
