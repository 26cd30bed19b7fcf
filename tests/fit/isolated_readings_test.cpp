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
            "6 readings of axial displacement jump and return while the speed is steady and are "
            "not used, rows 36, 101, 102, 223, 341, 456");
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
  EXPECT_EQ(
      found.statement(),
      "2 readings of axial displacement jump and return while the speed is steady, or by "
      "more than three times the range of the other readings, and are not used, rows 61, 341");
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
  const Isolated found =
      without_isolated_readings(record, record::axial_displacement, {}, predicted);
  EXPECT_EQ(found.rows, chips);
  EXPECT_EQ(
      found.statement(),
      "4 readings of axial displacement jump and return relative to the fitted model, and are "
      "not used, rows 32, 91, 92, 151");
}

/// 40 states of a rig, torques of 10 to 98 N mm.
record::Record states() {
  std::vector<double> speeds, temperatures, torques;
  for (int i = 0; i < 40; ++i) {
    speeds.push_back((1000.0 + 200.0 * (i % 20)) * rpm);
    temperatures.push_back(kelvin(25.0 + 0.5 * (i % 9)));
    torques.push_back((10.0 + 88.0 * (i % 20) / 19.0) * N_mm);
  }
  record::Record record;
  record.set(record::speed, speeds);
  record.set(record::temperature, temperatures);
  record.set(record::friction_torque, torques);
  return record;
}

TEST(ImpossibleRows, AReadingFarBeyondAllOthersIsNamedAndLeftOut) {
  EXPECT_TRUE(without_impossible_rows(states()).statements.empty());
  record::Record record = states();
  record.find(record::friction_torque)->values[12] = 1000.0 * N_mm;
  const PossibleRows found = without_impossible_rows(record);
  EXPECT_EQ(found.record.rows(), 39u);
  ASSERT_EQ(found.statements.size(), 1u);
  EXPECT_EQ(found.statements.front(),
            "1 row has a friction torque that differs from all other readings by more than three "
            "times the range of these readings and is not used, line 13");
  // At a speed that no other row has it may be true.
  record.find(record::speed)->values[12] = 20000.0 * rpm;
  EXPECT_TRUE(without_impossible_rows(record).statements.empty());
}

TEST(ImpossibleRows, ATemperatureThatNoOilHasIsNamedAndLeftOut) {
  record::Record record = states();
  record.find(record::temperature)->values[3] = kelvin(-200.0);
  record.find(record::temperature)->values[30] = kelvin(372.0);
  const PossibleRows found = without_impossible_rows(record);
  EXPECT_EQ(found.record.rows(), 38u);
  EXPECT_EQ(
      found.statements.front(),
      "2 rows have an impossible temperature (outside -60 to 200 C) and are not used, lines 4, 31");
}

/// What a control sets may leap; what has a heat capacity may not.
TEST(IsolatedReadings, OfAnInputLeaveByItsWholeRange) {
  record::Record record = lagging();
  std::vector<double> warm;
  for (const double n : record.values(record::speed)) warm.push_back(kelvin(20.0 + 0.01 * n / rpm));
  record.set(record::outer_ring_temperature, warm);
  const Isolation by{.steady = false, .impossible = 1.0};
  EXPECT_FALSE(without_isolated_readings(record, record::outer_ring_temperature, by).any());
  record.find(record::outer_ring_temperature)->values[200] = kelvin(120.0);
  const Isolated found = without_isolated_readings(record, record::outer_ring_temperature, by);
  EXPECT_EQ(found.statement(),
            "1 reading of outer ring temperature jumps and returns by more than the range of the "
            "other readings and is not used, rows 201");
}

}  // namespace
}  // namespace raceway::fit
