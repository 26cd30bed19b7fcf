#include "spindle/warm_start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record/spindle_channel.h"
#include "spindle/spindle_subject.h"
#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

constexpr double hour = 3600.0, speed = 8000.0 * rpm, room = kelvin(20);

model::Model with_thermometers() {
  model::Model m = base_spindle();
  using Part = model::ThermometerPlace::Part;
  const auto add = [&](const char* name, Part part, double position, double radius) {
    m.spindle->sensors.push_back(
        {.name = name, .part = part, .position = position * mm, .radius = radius * mm});
  };
  add("front", Part::ring, 60, 53);
  add("rear", Part::ring, 290, 53);
  add("end", Part::shaft, 365, 29);
  return m;
}

/// An hour of readings every minute, after so long at the same speed; the displacement counts from
/// the first row.
record::Record recorded_after(double before) {
  const model::Model model = with_thermometers();
  std::vector<ProfileRow> rows;
  for (double t = 60.0; t <= before + hour; t += 60.0)
    rows.push_back({.time = t, .inputs = {.speed = speed, .ambient_temperature = room}});
  const Run run = Simulator(model).simulate(rows);
  record::Record record;
  std::vector<double> time, speeds, ambient, moved;
  std::vector<std::vector<double>> read(model.spindle->sensors.size());
  double zero = unset;
  for (const Moment& m : run.moments) {
    if (m.time <= before) continue;
    if (std::isnan(zero)) zero = before > 0.0 ? m.displacement : 0.0;
    time.push_back(m.time - before);
    speeds.push_back(speed);
    ambient.push_back(room);
    moved.push_back(m.displacement - zero);
    for (std::size_t k = 0; k < read.size(); ++k) read[k].push_back(m.sensors[k]);
  }
  record.set(record::time, time);
  record.set(record::speed, speeds);
  record.set(*record::spindle_channel("ambient_temperature_C"), ambient);
  record.set(record::axial_displacement, moved);
  for (std::size_t k = 0; k < read.size(); ++k)
    record.set(record::sensor_channel(model.spindle->sensors[k].name), read[k]);
  return record;
}

TEST(WarmStart, IsTheSpindleThatHadRunBefore) {
  const record::Record record = recorded_after(2.0 * hour);
  const SpindleSubject subject(with_thermometers());
  ASSERT_EQ(subject.warm_starts(record).size(), 1U);
  const std::vector<double> predicted = fit::predict(subject, record);
  const std::span<const double> read = record.values(record::axial_displacement);
  double largest = 0.0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_NEAR(predicted[i], read[i], 0.1 * um) << i;
    largest = std::max(largest, std::abs(read[i]));
  }
  // From cold it would have moved by far more.
  const record::Record cold = recorded_after(0.0);
  EXPECT_GT(std::abs(cold.value(record::axial_displacement, read.size() - 1)), largest + 3.0 * um);
}

TEST(WarmStart, AZeroThatWasSetWarmIsNoOffset) {
  record::Record record = recorded_after(2.0 * hour);
  const std::vector<double> predicted = fit::predict(SpindleSubject(with_thermometers()), record);
  // The same readings by a transducer that was set a little later.
  for (double& u : record.find(record::axial_displacement)->values) u += 1.5 * um;
  const std::vector<double> later = fit::predict(SpindleSubject(with_thermometers()), record);
  for (std::size_t i = 0; i < record.rows(); ++i)
    EXPECT_NEAR(later[i], predicted[i] + 1.5 * um, 1e-3 * um) << i;
}

TEST(WarmStart, IsNoneOfARunFromCold) {
  const SpindleSubject subject(with_thermometers());
  EXPECT_TRUE(subject.warm_starts(recorded_after(0.0)).empty());
}

TEST(WarmStart, NeedsTheTemperatureOfTheRoom) {
  const record::Record record = recorded_after(2.0 * hour);
  record::Record without = record;
  std::erase_if(without.columns, [](const record::Column& c) {
    return *c.channel == *record::spindle_channel("ambient_temperature_C");
  });
  EXPECT_TRUE(SpindleSubject(with_thermometers()).warm_starts(without).empty());
}

}  // namespace
}  // namespace raceway::spindle
