#include "fit/isolated_readings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace raceway::fit {
namespace {

constexpr double um = 1e-6;

/// A machine that follows its speed with a lag of ten minutes, read every minute; the speed changes
/// every hour.
record::Record lagging(double noise = 0.2) {
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  std::vector<double> time, speeds, read;
  double now = 0.0;
  for (int i = 0; i < 600; ++i) {
    const double n = 1000.0 * ((i / 60) * 7 % 5);
    now += (0.01 * n - now) / 10.0;
    time.push_back(60.0 * i);
    speeds.push_back(n * rpm);
    read.push_back((now + noise * gauss(random)) * um);
  }
  record::Record record;
  record.set(record::time, time);
  record.set(record::speed, speeds);
  record.set(record::axial_displacement, read);
  return record;
}

record::Record with(record::Record record, const std::vector<std::size_t>& rows, double off) {
  for (const std::size_t row : rows)
    record.find(record::axial_displacement)->values[row] += off * um;
  return record;
}

TEST(IsolatedReadings, AreNoneWhereAMachineFollowsItsSpeed) {
  EXPECT_FALSE(without_isolated_readings(lagging()).any());
  EXPECT_FALSE(without_isolated_readings(lagging(0.0)).any());
}

TEST(IsolatedReadings, LeaveAndReturnAndTakeNoPart) {
  const std::vector<std::size_t> chips{35, 100, 101, 222, 340, 455};
  const record::Record record = with(lagging(), chips, -8.0);
  const Isolated found = without_isolated_readings(record);
  EXPECT_EQ(found.rows, chips);
  const auto left = found.record.values(record::axial_displacement);
  const auto read = record.values(record::axial_displacement);
  for (std::size_t i = 0; i < left.size(); ++i) {
    const bool is_chip = std::find(chips.begin(), chips.end(), i) != chips.end();
    EXPECT_EQ(std::isnan(left[i]), is_chip) << i;
    if (!is_chip) {
      EXPECT_EQ(left[i], read[i]);
    }
  }
  EXPECT_EQ(found.statement(),
            "6 readings of axial displacement leave and return while the speed is steady and take "
            "no part, rows 36, 101, 102, 223, 341, 456");
}

TEST(IsolatedReadings, AJumpThatStaysIsNone) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 330; i < 600; ++i) rows.push_back(i);
  EXPECT_FALSE(without_isolated_readings(with(lagging(), rows, -8.0)).any());
  EXPECT_FALSE(without_isolated_readings(with(lagging(), {330, 331, 332}, -8.0)).any());
}

TEST(IsolatedReadings, AreNotLookedForWhereTheSpeedChanges) {
  EXPECT_FALSE(without_isolated_readings(with(lagging(), {60, 119}, -8.0)).any());
}

/// One reading of 1000 among 0 to 40 is none, also at a change of speed and without a speed.
TEST(IsolatedReadings, BeyondTheRangeOfAllOthersNeedNoSteadySpeed) {
  record::Record record = with(lagging(), {60, 340}, 1000.0);
  const Isolated found = without_isolated_readings(record);
  EXPECT_EQ(found.rows, (std::vector<std::size_t>{60, 340}));
  EXPECT_EQ(found.statement(),
            "2 readings of axial displacement leave and return while the speed is steady, or by "
            "more than three times the range of the others, and take no part, rows 61, 341");
  // A step of that size which stays is the machine, or another zero.
  std::vector<std::size_t> rows;
  for (std::size_t i = 330; i < 600; ++i) rows.push_back(i);
  EXPECT_FALSE(without_isolated_readings(with(lagging(), rows, 1000.0)).any());
}

/// A spindle that runs for a minute every half hour moves at once, and is at rest for all the rest.
TEST(IsolatedReadings, ShortRunsOfAMachineAtRestAreNone) {
  record::Record record = lagging();
  std::vector<double>& speeds = record.find(record::speed)->values;
  std::vector<double>& read = record.find(record::axial_displacement)->values;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const bool runs = i % 30 == 15;
    speeds[i] = runs ? 6000 * rpm : 0.0;
    read[i] = (runs ? 20.0 : 0.1 * static_cast<double>(i % 3)) * um;
  }
  EXPECT_FALSE(without_isolated_readings(record).any());
}

TEST(IsolatedReadings, SoManyAreNone) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 2; i < 600; i += 5) rows.push_back(i);
  EXPECT_FALSE(without_isolated_readings(with(lagging(), rows, -8.0)).any());
}

/// Every five minutes, where speeds change every quarter of an hour.
TEST(IsolatedReadings, AreToldByAModelWhereTheSpeedChanges) {
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  std::vector<double> time, speeds, read, predicted;
  for (int i = 0; i < 200; ++i) {
    const double n = 1000.0 * ((i / 3) * 7 % 5), drift = 3.0 * std::sin(i / 30.0);
    time.push_back(300.0 * i);
    speeds.push_back(n * rpm);
    predicted.push_back(0.004 * n * um);
    read.push_back((0.004 * n + drift + 0.2 * gauss(random)) * um);
  }
  const std::vector<std::size_t> chips{31, 90, 91, 150};
  for (const std::size_t row : chips) read[row] -= 9.0 * um;
  // This one the machine did, with its speed, and the model does not know of it.
  speeds[120] += 900.0 * rpm;
  read[120] += 9.0 * um;
  record::Record record;
  record.set(record::time, time);
  record.set(record::speed, speeds);
  record.set(record::axial_displacement, read);
  EXPECT_FALSE(without_isolated_readings(record).any());
  const Isolated found = without_isolated_readings(record, record::axial_displacement, predicted);
  EXPECT_EQ(found.rows, chips);
  EXPECT_EQ(found.statement(),
            "4 readings of axial displacement leave and return, against the fitted model, and take "
            "no part, rows 32, 91, 92, 151");
}

}  // namespace
}  // namespace raceway::fit
