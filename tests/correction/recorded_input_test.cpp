#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "correction/correction_subject.h"
#include "loop/loop.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double hour_s = 3600.0;

/// The lag of a temperature above that of the base, by Euler in steps of the record.
std::vector<double> lag_above_base(const MadeRecord& made, const std::string& name, double tau) {
  const auto above = made.record.values(*record::series_channel(name + "_temperature_C"));
  const auto base = made.record.values(*record::series_channel("base_temperature_C"));
  std::vector<double> x(made.time.size());
  for (std::size_t k = 1; k < x.size(); ++k)
    x[k] = x[k - 1] + (made.time[k] - made.time[k - 1]) / tau *
                          (above[k - 1] - base[k - 1] - (above[0] - base[0]) - x[k - 1]);
  return x;
}

/// A spindle and a table, each warm for itself; `every` minutes one reading.
MadeRecord of_spindle_and_table(double table_um_K, double every) {
  MadeRecord made(48 * hour_s, 120);
  made.with("base_temperature_C", [](double t) { return 21 + 0.6 * std::sin(t / (4 * hour_s)); })
      .with("spindle_temperature_C",
            [](double t) { return 24 + 4 * std::sin(t / (1.3 * hour_s)) + std::sin(t / 2500); })
      .with("table_temperature_C",
            [](double t) { return 23 + 3 * std::sin(t / (2.1 * hour_s) + 1) + std::cos(t / 3100); })
      .with("door_temperature_C", [](double t) { return 22 + 2 * std::cos(t / (1.7 * hour_s)); });
  const std::vector<double> spindle = lag_above_base(made, "spindle", 3600),
                            table = lag_above_base(made, "table", 5000);
  std::mt19937 engine(11);
  std::normal_distribution<double> noise(0.0, 0.2);
  std::size_t k = 0;
  made.with("displacement_z_um", [&](double t) {
    const std::size_t row = k++;
    const bool read = std::fmod(t, 60 * every) == 0.0;
    return read ? 5 * spindle[row] + table_um_K * table[row] + noise(engine) : unset;
  });
  return made;
}

Model of_the_spindle_alone() {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.tolerance = 1e-6;
  m.channels.push_back({.name = "spindle",
                        .input = {.name = "spindle_temperature_C",
                                  .columns = {record::series_channel("spindle_temperature_C")},
                                  .reference = record::series_channel("base_temperature_C")},
                        .sections = {{3e-6, 2500}}});
  return m;
}

TEST(RecordedInput, TheColumnThatMovesTheMachineIsNamedAndAdded) {
  const MadeRecord made = of_spindle_and_table(3.0, 2);
  const CorrectionSubject subject(of_the_spindle_alone());
  const verdict::Diagnosis d = loop::diagnose(subject, made.record);
  EXPECT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  ASSERT_FALSE(d.sets.empty());
  EXPECT_THAT(d.sets.front(), ElementsAre("input:table_temperature_C"));
  const std::vector<std::string> ids{"input:table_temperature_C"};
  const auto added = loop::add(subject, ids, made.record);
  const Model found = model_of(*added.calibration.subject);
  ASSERT_EQ(found.effects.size(), 1U);
  EXPECT_NEAR(found.effects[0].values[0], 3.0, 0.05);    // um/K
  EXPECT_NEAR(found.effects[0].values[1], 5000, 200.0);  // s
}

TEST(RecordedInput, ColumnsThatMoveNothingAreNotNamed) {
  const verdict::Diagnosis d = loop::diagnose(CorrectionSubject(of_the_spindle_alone()),
                                              of_spindle_and_table(0.0, 2).record);
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
}

/// As of_spindle_and_table(), and what else a control records: the power of the table, an axis.
MadeRecord with_power_and_position(double power_um_W, double position_um_mm) {
  MadeRecord made = of_spindle_and_table(0.0, 2);
  made.with("table_W", [](double t) { return 150 + 150 * std::sin(t / (1.9 * hour_s)); })
      .with("x_position_mm", [](double t) { return 300 + 250 * std::sin(t / 900); });
  std::vector<double> x(made.time.size());
  const auto power = made.record.values(*record::series_channel("table_W"));
  const auto position = made.record.values(*record::series_channel("x_position_mm"));
  std::vector<double>& z = made.record.find(*record::series_channel("displacement_z_um"))->values;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (k > 0)
      x[k] = x[k - 1] + (made.time[k] - made.time[k - 1]) / 4000 * (power[k - 1] - x[k - 1]);
    z[k] += power_um_W * um * x[k] + position_um_mm * um * (position[k] / 1e-3);
  }
  return made;
}

std::vector<std::string> named_by(const MadeRecord& made) {
  const verdict::Diagnosis d =
      loop::diagnose(CorrectionSubject(of_the_spindle_alone()), made.record);
  EXPECT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  return d.sets.empty() ? std::vector<std::string>{} : d.sets.front();
}

TEST(RecordedInput, APowerOrAPositionIsNamed) {
  EXPECT_THAT(named_by(with_power_and_position(0.06, 0)), ElementsAre("input:table_W"));
  const MadeRecord made = with_power_and_position(0, 0.03);
  EXPECT_THAT(named_by(made), ElementsAre("input:x_position_mm"));
  const std::vector<std::string> ids{"input:x_position_mm"};
  const auto added = loop::add(CorrectionSubject(of_the_spindle_alone()), ids, made.record);
  const Model found = model_of(*added.calibration.subject);
  ASSERT_EQ(found.effects.size(), 1U);
  ASSERT_EQ(found.effects[0].values.size(), 1U);  // at once
  EXPECT_NEAR(found.effects[0].values[0], 0.03, 0.001);
}

/// A spindle that moves the tool by 5 um/K, and where the axis stands in its upper half by `more`
/// um/K beyond that.
MadeRecord with_a_position(double more) {
  MadeRecord made = of_spindle_and_table(0.0, 2);
  made.with("x_position_mm", [](double t) { return 300 + 300 * std::sin(t / 4100); });
  const std::vector<double> spindle = lag_above_base(made, "spindle", 3600);
  const auto position = made.record.values(*record::series_channel("x_position_mm"));
  std::vector<double>& z = made.record.find(*record::series_channel("displacement_z_um"))->values;
  for (std::size_t k = 0; k < z.size(); ++k)
    if (position[k] >= 0.3) z[k] += more * um * spindle[k];
  return made;
}

TEST(WindowOfAPosition, IsNamedByItsPositionAndRangeAndAdded) {
  const MadeRecord made = with_a_position(2.5);
  EXPECT_THAT(named_by(made), ElementsAre("input:x_position_mm:300.."));
  const std::vector<std::string> ids{"input:x_position_mm:300.."};
  const auto added = loop::add(CorrectionSubject(of_the_spindle_alone()), ids, made.record);
  const Model found = model_of(*added.calibration.subject);
  ASSERT_EQ(found.effects.size(), 1U);
  ASSERT_TRUE(found.effects[0].window);
  EXPECT_NEAR(found.effects[0].values[0], 2.5, 0.1);
  EXPECT_NEAR(found.effects[0].values[1], 3600, 250);
}

TEST(WindowOfAPosition, OfAnAxisThatMovesNothingIsNotNamed) {
  const verdict::Diagnosis d =
      loop::diagnose(CorrectionSubject(of_the_spindle_alone()), with_a_position(0.0).record);
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
}

// Thirty columns that wander have nothing to do with a misfit that wanders, too.
TEST(RecordedInput, OneOfManyThatHappensToFollowIsNotNamed) {
  int named = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    MadeRecord made(12 * hour_s, 120);
    std::mt19937 engine(seed);
    std::normal_distribution<double> step(0.0, 1.0);
    const auto walk = [&](const std::string& name, double size) {
      double x = 0.0;
      made.with(name, [&](double) { return x = 0.995 * x + size * step(engine); });
    };
    walk("spindle_temperature_C", 0.3);
    made.with("base_temperature_C", [](double t) { return 21 + 0.3 * std::sin(t / 9000); });
    for (int k = 0; k < 30; ++k) walk("drive" + std::to_string(k) + "_W", 10.0);
    walk("displacement_z_um", 0.6);
    const verdict::Diagnosis d =
        loop::diagnose(CorrectionSubject(of_the_spindle_alone()), made.record);
    for (const std::vector<std::string>& set : d.sets)
      for (const std::string& id : set) named += id.starts_with("input:drive") ? 1 : 0;
  }
  EXPECT_EQ(named, 0);
}

// A test piece is touched every two hours.
TEST(FewReadings, GetAVerdictWithACaution) {
  const verdict::Diagnosis d = loop::diagnose(CorrectionSubject(of_the_spindle_alone()),
                                              of_spindle_and_table(0.0, 120).record);
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  EXPECT_THAT(
      texts(d.messages),
      testing::Contains(HasSubstr("only 25 readings of displacement z: the verdict is a hint")));
  EXPECT_THAT(
      [] {
        (void)loop::diagnose(CorrectionSubject(of_the_spindle_alone()),
                             of_spindle_and_table(0.0, 240).record);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("13 readings")));
}

}  // namespace
}  // namespace raceway::correction
