#include "fit/dwells.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <vector>

#include "fit/noise_model.h"
#include "record/units.h"

namespace raceway::fit {
namespace {

using record::axial_load;
using record::friction_torque;
using record::speed;
using record::temperature;
using testing::HasSubstr;

/// What a logger writes, row by row in the units of files.
struct Log {
  std::vector<double> time, rpm, load, celsius, torque;

  void add(double t, double n, double F, double T, double M) {
    time.push_back(t);
    rpm.push_back(n);
    load.push_back(F);
    celsius.push_back(T);
    torque.push_back(M);
  }
  [[nodiscard]] record::Record record() const {
    record::Record r{.source = "log.csv"};
    const auto set = [&](const record::Channel& channel, std::vector<double> values) {
      for (double& v : values) v = channel.to_SI(v);
      r.set(channel, std::move(values));
    };
    set(record::time, time);
    set(speed, rpm);
    set(axial_load, load);
    set(temperature, celsius);
    set(friction_torque, torque);
    return r;
  }
};

/// Dwells of `rows` at 1 Hz: scatter of `share` of the torque, which forgets itself in `memory`
/// [s].
Log stairs(int rows, double share, double memory, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double kept = memory > 0.0 ? std::exp(-1.0 / memory) : 0.0;
  Log log;
  double start = 0.0;
  for (const double F : {250.0, 600.0, 1400.0, 3000.0})
    for (const double n :
         {600.0, 900.0, 1400.0, 2100.0, 3100.0, 4700.0, 7000.0, 10600.0, 16000.0}) {
      double state = normal(random);
      for (int i = 0; i < rows; ++i) {
        if (i > 0) state = kept * state + std::sqrt(1.0 - kept * kept) * normal(random);
        log.add(start + i, n * (1.0 + 3e-4 * normal(random)), F + 0.2 * normal(random),
                25.0 + n / 1000.0 + 0.05 * normal(random), 200.0 * (1.0 + share * state));
      }
      start += 900.0;
    }
  return log;
}

TEST(Dwells, AreTheRowsOfEachState) {
  const Averaged averaged = average_dwells(stairs(40, 0.01, 15.0, 1).record());
  EXPECT_EQ(averaged.rows, 1440U);
  EXPECT_EQ(averaged.dwells, 36U);
  EXPECT_EQ(averaged.alone, 0U);
  ASSERT_EQ(averaged.record.rows(), 36U);
  EXPECT_THAT(averaged.statement(), HasSubstr("1440 rows form 36 dwells"));
  EXPECT_THAT(averaged.statement(), HasSubstr("friction torque"));
  // Of the first: 40 rows from 0 to 39 s, the last in row 40.
  EXPECT_DOUBLE_EQ(averaged.record.value(record::time, 0), 19.5);
  EXPECT_EQ(averaged.record.value(dwell_rows, 0), 40.0);
  EXPECT_EQ(averaged.record.value(dwell_last_line, 0), 40.0);
  // Standard errors of 3e-4/sqrt(40) and 0.05 K/sqrt(40); four of them.
  EXPECT_NEAR(averaged.record.value(speed, 8) / rpm, 16000.0, 4 * 0.76);
  EXPECT_NEAR(temperature.in_unit(averaged.record.value(temperature, 8)), 41.0, 4 * 0.008);
}

// A mean of correlated rows is no better than its few independent ones: of 40 rows that forget
// themselves in 15 s, sum_ik φ^|i-k| / 40² = 0.51 of the variance is left, where 1/40 would be that
// of independent ones.
TEST(Dwells, MeansScatterByTheCorrelationOfTheirRows) {
  const double phi = std::exp(-1.0 / 15.0);
  double sum = 0.0;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k) sum += std::pow(phi, std::abs(i - k));
  const double correlated = 0.01 * std::sqrt(sum) / 40.0, independent = 0.01 / std::sqrt(40.0);
  double found_correlated = 0.0, found_independent = 0.0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    // All torques are alike, so that a share of their rms is one of the torque.
    found_correlated +=
        average_dwells(stairs(40, 0.01, 15.0, seed).record()).record.value(dwell_scatter, 5) / 8;
    found_independent +=
        average_dwells(stairs(40, 0.01, 0.0, seed).record()).record.value(dwell_scatter, 5) / 8;
  }
  // 36 dwells with some three independent rows each know their scatter to 10 %, and the grid of
  // correlations is as coarse.
  EXPECT_NEAR(found_correlated / correlated, 1.0, 0.15);
  EXPECT_NEAR(found_independent / independent, 1.0, 0.1);
}

TEST(Dwells, AreCutWhereTheTemperatureMoves) {
  Log log = stairs(60, 0.01, 0.0, 3);
  for (std::size_t i = 0; i < log.celsius.size(); ++i)
    log.celsius[i] += 3.5 * static_cast<double>(i % 60) / 60.0;
  const Averaged averaged = average_dwells(log.record());
  EXPECT_EQ(averaged.split, 36U);
  EXPECT_EQ(averaged.dwells, 36U * 4U);
  // The pieces of a dwell stand at one state.
  EXPECT_EQ(averaged.record.value(dwell_state, 0), averaged.record.value(dwell_state, 3));
  EXPECT_NE(averaged.record.value(dwell_state, 3), averaged.record.value(dwell_state, 4));
}

TEST(Dwells, ARampHasNone) {
  Log log;
  for (int i = 0; i < 1500; ++i)  // 10 rpm/s, slow enough to stand at a level for some rows
    log.add(i, 600.0 + 10.0 * i, 500.0, 30.0 + 0.01 * i, 200.0);
  EXPECT_FALSE(average_dwells(log.record()).any());
}

TEST(Dwells, ARowForEachStateStaysARow) {
  EXPECT_FALSE(average_dwells(stairs(1, 0.01, 0.0, 4).record()).any());
  EXPECT_FALSE(average_dwells(stairs(3, 0.01, 0.0, 4).record()).any());  // repeats
  // One point measured again and again, every ten minutes.
  Log repeats;
  for (int i = 0; i < 30; ++i) repeats.add(600.0 * i, 3000.0, 500.0, 40.0, 200.0);
  EXPECT_FALSE(average_dwells(repeats.record()).any());
  // A temperature that is set from row to row is no drift.
  Log steps;
  for (int i = 0; i < 30; ++i) steps.add(60.0 * i, 3000.0, 500.0, 25.0 + 2.0 * i, 200.0);
  EXPECT_FALSE(average_dwells(steps.record()).any());
}

TEST(Dwells, LeaveRowsWithAStandardDeviationAlone) {
  record::Record record = stairs(40, 0.01, 15.0, 5).record();
  record.set(record::torque_deviation, std::vector<double>(record.rows(), 2.0 * N_mm));
  EXPECT_FALSE(average_dwells(record).any());
}

TEST(Dwells, RowsOnFastRampsBetweenThemAreLeftOut) {
  Log log;
  double t = 0.0;
  const auto add = [&](double rpm, double torque) { log.add(t++, rpm, 500.0, 40.0, torque); };
  for (const double n : {1000.0, 3000.0, 5000.0}) {
    for (int i = 0; i < 40; ++i) add(n, n / 10.0 + 0.1 * (i % 3));
    // The rotor takes much more than its friction.
    for (int i = 1; i < 5; ++i) add(n + 400.0 * i, 2000.0);
  }
  const Averaged averaged = average_dwells(log.record());
  EXPECT_EQ(averaged.dwells, 3U);
  EXPECT_EQ(averaged.ramps, 11U);
  EXPECT_EQ(averaged.alone, 1U);  // the last row, which nothing follows
  EXPECT_THAT(averaged.statement(), HasSubstr("11 rows on fast ramps between dwells are not used"));
  // After a single dwell, the ramp is the measurement.
  Log one;
  for (int i = 0; i < 20; ++i) one.add(i, 500.0 + 100.0 * i, 500.0, 40.0, 100.0 + i);
  for (int i = 20; i < 60; ++i) one.add(i, 2500.0, 500.0, 40.0, 120.0 + 0.1 * (i % 3));
  EXPECT_EQ(average_dwells(one.record()).ramps, 0U);
  // Rows of a slow ramp are measurements.
  Log slow;
  for (int i = 0; i < 40; ++i) slow.add(i, 1000.0, 500.0, 40.0, 100.0 + 0.1 * (i % 3));
  for (int i = 1; i < 40; ++i) slow.add(39 + i, 1000.0 + 4.0 * i, 500.0, 40.0, 100.0);
  for (int i = 0; i < 40; ++i) slow.add(79 + i, 1156.0, 500.0, 40.0, 100.0 + 0.1 * (i % 3));
  EXPECT_EQ(average_dwells(slow.record()).ramps, 0U);
}

TEST(Dwells, StrayRowsBetweenThemStayRows) {
  Log log = stairs(40, 0.01, 0.0, 6);
  log.rpm[20] = 3000.0;  // within the first dwell
  const Averaged averaged = average_dwells(log.record());
  EXPECT_EQ(averaged.alone, 1U);
  EXPECT_EQ(averaged.dwells, 37U);
  EXPECT_EQ(averaged.record.value(dwell_state, 0), averaged.record.value(dwell_state, 2));
}

}  // namespace
}  // namespace raceway::fit
