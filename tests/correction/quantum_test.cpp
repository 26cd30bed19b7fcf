#include "correction/quantum.h"

#include <gmock/gmock.h>

#include <cmath>

#include "correction/correction_subject.h"
#include "loop/loop.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::ElementsAre;

const record::Channel& front() { return *record::series_channel("front_bearing_temperature_C"); }

TEST(Quantum, IsTheStepOfWhichAllAreMultiples) {
  const double zero = front().to_SI(20.0);
  EXPECT_NEAR(quantum_of(front(), std::vector{zero, zero + 1.5, zero + 0.5, zero + 2.0}), 0.5,
              1e-9);
  EXPECT_TRUE(
      std::isnan(quantum_of(front(), std::vector{zero, zero + 1.0, zero + 1.45, zero + 3})));
  EXPECT_TRUE(std::isnan(quantum_of(front(), std::vector{zero, zero, zero})));
}

TEST(Quantum, BetweenChangesItGoesStraight) {
  const std::vector<double> time{0, 10, 20, 30, 40, 50, 60};
  // Up by one between 10 and 20 s and between 50 and 60 s: half-way at 15 and 55 s.
  EXPECT_THAT(between_digits(time, std::vector<double>{0, 0, 1, 1, 1, 1, 2},
                             std::vector<bool>{true, false, false, false, false, false, false}),
              ElementsAre(testing::DoubleEq(0.0), testing::DoubleNear(1.0 / 3.0, 1e-12),
                          testing::DoubleNear(0.625, 1e-12), testing::DoubleNear(0.875, 1e-12),
                          testing::DoubleNear(1.125, 1e-12), testing::DoubleNear(1.375, 1e-12),
                          testing::DoubleEq(2.0)));
}

TEST(Quantum, AtATurnItReachesTheDigit) {
  const std::vector<double> time{0, 10, 20, 30, 40};
  const std::vector<double> met =
      between_digits(time, std::vector<double>{0, 1, 1, 1, 0},
                     std::vector<bool>{true, false, false, false, false});
  EXPECT_DOUBLE_EQ(met[2], 1.0);
  EXPECT_LT(met[1], 1.0);
}

TEST(Quantum, RunsAreApart) {
  const std::vector<double> met =
      between_digits(std::vector<double>{0, 10, 0, 10}, std::vector<double>{0, 1, 5, 5},
                     std::vector<bool>{true, false, true, false});
  EXPECT_DOUBLE_EQ(met[2], 5.0);
  EXPECT_DOUBLE_EQ(met[3], 5.0);
}

/// A spindle that follows its bearing at once and through a body, read by a sensor in steps.
MadeRecord record_of_sensor(double quantum) {
  constexpr double hour = 3600.0;
  MadeRecord made(24.0 * hour, 30.0);
  double warm = 0.0, body = 0.0;
  std::vector<double> bearing, moved;
  for (std::size_t k = 0; k < made.time.size(); ++k) {
    bearing.push_back(warm);
    moved.push_back(8.0 * warm + 4.0 * body);
    warm += 30.0 / 900.0 * (2.5e-3 * stepped_speed(made.time[k], hour) - warm);
    body += 30.0 / 5000.0 * (warm - body);
  }
  const auto row = [&](double t) { return static_cast<std::size_t>(std::lround(t / 30.0)); };
  made.with("speed_rpm", [&](double t) { return stepped_speed(t, hour); });
  made.with("front_bearing_temperature_C",
            [&](double t) { return 20.0 + quantum * std::round(bearing[row(t)] / quantum); });
  made.with("displacement_z_um", [&](double t) {
    return moved[row(t)] + 0.2 * std::sin(12.9898 * static_cast<double>(row(t)));
  });
  return made;
}

Model with_feedthrough() {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.tolerance = 1e-6;
  m.channels.push_back({.name = "spindle",
                        .input = {.name = "front_bearing_temperature_C", .columns = {&front()}},
                        .sections = {{3e-6, 4000}},
                        .feedthrough = 6e-6});
  return m;
}

TEST(Quantum, ASensorThatStepsIsTheVerdict) {
  const MadeRecord made = record_of_sensor(2.0);
  const verdict::Diagnosis d = loop::diagnose(CorrectionSubject(with_feedthrough()), made.record);
  ASSERT_FALSE(d.sets.empty()) << d.sentence;
  EXPECT_THAT(d.sets.front(), ElementsAre("sensor-quantisation")) << d.sentence;
  EXPECT_TRUE(d.verdict == verdict::Verdict::effect || d.verdict == verdict::Verdict::effect_like);
  EXPECT_THAT(d.effects.front().datum, testing::HasSubstr("front_bearing_temperature_C"));
}

TEST(Quantum, AFineSensorIsNone) {
  const MadeRecord made = record_of_sensor(0.1);
  const verdict::Diagnosis d = loop::diagnose(CorrectionSubject(with_feedthrough()), made.record);
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  const auto fitted = CorrectionSubject(with_feedthrough()).informed_by(made.record);
  EXPECT_TRUE(fitted->faults(made.record).empty());
}

TEST(Jumps, ThreeOfThemAreFoundWhereTheyAre) {
  MadeRecord made = record_of_sensor(0.1);
  constexpr double jumps[][2] = {{20000.0, 9.0}, {45000.0, -7.0}, {80000.0, 8.0}};
  std::vector<double>& read =
      made.record.find(*record::series_channel("displacement_z_um"))->values;
  for (std::size_t k = 0; k < read.size(); ++k)
    for (const auto& [time, size] : jumps)
      if (made.time[k] >= time) read[k] += size * 1e-6;
  const verdict::Diagnosis d = loop::diagnose(CorrectionSubject(with_feedthrough()), made.record);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_THAT(d.sets.front(), ElementsAre("offset-jump"));
  for (const auto& [time, size] : jumps) {
    bool found = false;
    const std::vector<fit::Parameter>& p = d.effects.front().parameters;
    for (std::size_t k = 0; k + 1 < p.size(); k += 2)
      found =
          found || (std::abs(p[k].value - size) < 0.3 && std::abs(p[k + 1].value - time) < 60.0);
    EXPECT_TRUE(found) << size << " um at " << time << " s";
  }
}

TEST(SlowDrift, IsLookedForFromAShareOfTheRecordToFiveTimesIt) {
  const MadeRecord made = record_of_sensor(0.1);
  const auto informed = CorrectionSubject(with_feedthrough()).informed_by(made.record);
  for (const fit::Candidate& c : informed->candidates()) {
    if (c.id != "slow-drift") continue;
    EXPECT_NEAR(c.parameters[1].lower, 0.15 * 86400.0, 1.0);
    EXPECT_NEAR(c.parameters[1].upper, 5.0 * 86400.0, 1.0);
    return;
  }
  FAIL() << "no slow-drift";
}

}  // namespace
}  // namespace raceway::correction
