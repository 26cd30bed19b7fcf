#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "effects/catalogue.h"
#include "effects/sensor_drift.h"
#include "effects/sensor_gain.h"
#include "effects/sensor_offset.h"

namespace raceway::effects {
namespace {

const bearing::OperatingPoint warm{.speed = 3000 * rpm, .temperature = kelvin(65.0)};
const Record after_two_hours{.time = 7200.0};

double added(const char* id, std::vector<double> values, double value) {
  const Description& d = *find(id, find(id)->for_rig ? Form::rig : Form::shaft);
  EXPECT_EQ(values.size(), d.parameters.size());
  return d.reading({.value = value, .point = warm, .record = after_two_hours}, values);
}

TEST(Sensor, AddsInTheUnitOfItsChannel) {
  EXPECT_DOUBLE_EQ(added("torque-offset", {3.0}, 0.2), 3.0 * N_mm);
  EXPECT_DOUBLE_EQ(added("torque-gain", {0.05}, 0.2), 0.01);
  EXPECT_DOUBLE_EQ(added("torque-temperature-drift", {4.0, 40.0}, 0.2), 10.0 * N_mm);
  EXPECT_DOUBLE_EQ(added("torque-time-drift", {4.0}, 0.2), 8.0 * N_mm);
  EXPECT_DOUBLE_EQ(added("displacement-offset", {3.0}, 1e-5), 3.0 * um);
  EXPECT_DOUBLE_EQ(added("displacement-temperature-drift", {4.0, 40.0}, 1e-5), 10.0 * um);
  // Nothing at the temperature at which it was set to zero.
  EXPECT_DOUBLE_EQ(added("displacement-temperature-drift", {4.0, 65.0}, 1e-5), 0.0);
}

TEST(Sensor, ChannelDecidesWhereItMayStand) {
  for (const Description& d : all_forms()) {
    SCOPED_TRACE(std::string(d.id));
    EXPECT_EQ(d.reading != nullptr, d.channel != nullptr);
    EXPECT_EQ(d.reads(record::friction_torque), d.channel && d.for_rig);
    EXPECT_EQ(d.reads(record::axial_displacement), d.channel && !d.for_rig);
    if (!d.channel) continue;
    EXPECT_TRUE(d.for_shaft);  // its sets have a displacement and a torque
    EXPECT_NE(d.for_rig, d.for_spindle);
    EXPECT_EQ(d.step(), "reading");
  }
}

// A sensor of another channel is a card.
constexpr record::Channel housing{.name = "housing_temperature_C",
                                  .variable = "housing_temperature",
                                  .words = "housing temperature",
                                  .unit = "C",
                                  .offset = celsius_zero,
                                  .role = record::Role::measured};
constexpr SensorCard<1> thermocouple{
    .channel = housing,
    .id = "thermocouple-gain",
    .title = "gain error of a thermocouple",
    .mechanism = "",
    .formula = "",
    .confused_with = {"f0"},
    .size = {.name = "gain_error", .unit = "1", .initial = 0.0, .lower = -0.5, .upper = 0.5}};

TEST(Sensor, GainCountsFromTheZeroOfTheUnit) {
  const std::array values{0.1};
  using Gain = SensorGain<thermocouple, Need::viscosity_levels>;
  EXPECT_EQ(Gain::id, "thermocouple-gain");
  EXPECT_NEAR(
      Gain::reading({.value = kelvin(50.0), .point = warm, .record = after_two_hours}, values), 5.0,
      1e-12);
  EXPECT_EQ(Gain::reading({.value = kelvin(0.0), .point = warm, .record = after_two_hours}, values),
            0.0);
}

TEST(Record, HasTimeAndRingTemperaturesItselfAndTheRestFromItsRow) {
  const Record bare{.time = 5.0, .inner_ring_temperature = 310.0};
  EXPECT_EQ(bare.value(record::time), 5.0);
  EXPECT_EQ(bare.value(record::inner_ring_temperature), 310.0);
  EXPECT_TRUE(std::isnan(bare.value(record::outer_ring_temperature)));
  EXPECT_TRUE(std::isnan(bare.value(record::preload)));
  record::Record rows;
  rows.set(record::preload, {100.0, 200.0});
  rows.set(record::time, {1.0, 2.0});
  const Record second{.time = 5.0, .rows = &rows, .row = 1};
  EXPECT_EQ(second.value(record::preload), 200.0);
  EXPECT_EQ(second.value(record::time), 5.0);
  EXPECT_TRUE(std::isnan(second.value(record::speed)));
}

}  // namespace
}  // namespace raceway::effects
