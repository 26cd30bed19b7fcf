#include "correction/learning.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "correction/own_effect.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr double an_hour = 3600.0;

/// A lag of the bearing's temperature, of 8 um/K at an hour and a half, on a machine whose zero is
/// as its record has it.
Model model() {
  Model m{.name = "z",
          .displacement = record::series_channel("displacement_z_um"),
          .tolerance = 0.5 * um,
          .measured_std = 0.05 * um};
  m.channels.push_back({.name = "spindle",
                        .input = {.name = "front_temperature_C",
                                  .columns = {record::series_channel("front_temperature_C")}},
                        .sections = {{8 * um, 5400}}});
  return m;
}

double temperature(double t) { return 22 + 6 * std::sin(t / 9000) + 2 * std::sin(t / 2500); }

/// What a machine of this model moves, times `gain`, and what comes to it, in um.
record::Record machine(
    double gain, double hours,
    const std::function<double(double)>& more = [](double) { return 0.0; }) {
  MadeRecord made(hours * an_hour, 60);
  made.with("front_temperature_C", temperature);
  std::vector<double> y(made.time.size());
  simulate(model(), Series(made.record), y);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = gain * y[k] + more(made.time[k]) * um;
  made.record.set(*model().displacement, std::move(y));
  return made.record;
}

std::vector<double>& readings(record::Record& record) {
  return record.find(*model().displacement)->values;
}

/// The same with a reading every so many rows alone.
record::Record sparse(record::Record record, std::size_t every) {
  for (std::size_t k = 0; k < record.rows(); ++k)
    if (k % every != 0) readings(record)[k] = unset;
  return record;
}

double worst(const Learning& l, const record::Record& truth, std::size_t from) {
  double largest = 0.0;
  for (std::size_t k = from; k < truth.rows(); ++k)
    largest = std::max(largest, std::abs(l.predicted[k] - truth.value(*model().displacement, k)));
  return largest / um;
}

TEST(Learning, TakesTheZeroOfTheFirstReading) {
  const record::Record truth = machine(1.0, 20, [](double) { return 37.0; });
  const Learning l = learn(model(), sparse(truth, 600));
  EXPECT_NEAR(worst(l, truth, 1), 0.0, 1e-3);
  EXPECT_NEAR(l.predicted[0] - truth.value(*model().displacement, 0), -37.0 * um, 1e-12);
  EXPECT_TRUE(std::isnan(l.std[0]));  // nobody knows the zero
  EXPECT_GT(l.std[1], 0.0);
  EXPECT_NEAR(l.model.offset, 37.0 * um, 1e-3 * um);
  EXPECT_LT(l.level, 1.0);  // the model is better than it promised
}

/// 1 um/h: a zero of an hour ago is off by 0.58 um in the root mean square; the drift is learnt,
/// too.
TEST(Learning, FollowsAKnownDrift) {
  const record::Record truth = machine(1.0, 40, [](double t) { return t / an_hour; });
  const Learning l = learn(model(), truth, {.every = an_hour});
  EXPECT_THAT(l.readings, SizeIs(41));
  EXPECT_EQ(l.error.readings, truth.rows() - 41);
  EXPECT_NEAR(l.error.zeroed / um, 1.0 / std::sqrt(3.0), 0.02);
  EXPECT_LT(l.error.learnt, 0.9 * l.error.zeroed);
  EXPECT_TRUE(l.due.empty());
  EXPECT_NEAR(l.error.first / um, 40.0 / std::sqrt(3.0), 0.3);
}

TEST(Learning, LearnsAGainThatIsWrongByAFifthWithinSixReadings) {
  const record::Record truth = machine(1.2, 40, [](double) { return -11.0; });
  const std::size_t every = 120;
  const Learning six = learn(model(), sparse(truth.picked([] {
                               std::vector<std::size_t> rows;
                               for (std::size_t k = 0; k <= 5 * 120; ++k) rows.push_back(k);
                               return rows;
                             }()),
                                             every));
  ASSERT_THAT(six.readings, SizeIs(6));
  ASSERT_THAT(six.gains, SizeIs(1));
  EXPECT_EQ(six.gains[0].name, "spindle");
  EXPECT_NEAR(six.gains[0].value, 0.2, 0.01);
  EXPECT_LT(std::abs(six.gains[0].value - 0.2), 2.0 * six.gains[0].std);
  EXPECT_NEAR(six.model.channels[0].scale, 1.2, 0.01);
  const Learning all = learn(model(), sparse(truth, every));
  EXPECT_LT(worst(all, truth, 5 * every + 1), 0.6);
  EXPECT_GT(worst(learn(model(), sparse(truth, 100 * every)), truth, 5 * every + 1), 5.0);
}

TEST(Learning, LearnsTheGainOfAFormulaAndNoneOfOneRecord) {
  Model m = model();
  Effect squared{.id = "squared", .values = {0.5}};
  squared.own = std::make_shared<const OwnEffect>(
      OwnEffect::Given{.id = "squared", .formula = "(front_temperature_C - 22)^2"});
  m.effects = {std::move(squared), {.id = "slow-drift", .values = {3.0, 20000}}};
  const Learning l = learn(m, sparse(machine(1.0, 20), 120));
  ASSERT_THAT(l.gains, SizeIs(2));
  EXPECT_EQ(l.gains[0].name, "spindle");
  EXPECT_EQ(l.gains[1].name, "squared");
}

/// Whatever is read later, rows before stay as they are, to the last digit.
TEST(Learning, NothingLeaksFromTheFuture) {
  const record::Record truth = machine(1.1, 30, [](double t) { return 3 * std::sin(t / 20000); });
  const Learning before = learn(model(), truth, {.every = 2 * an_hour});
  for (const std::size_t row : {0UL, 1UL, 120UL, 600UL, 601UL, 1800UL}) {
    record::Record other = truth;
    for (std::size_t k = row; k < other.rows(); ++k) readings(other)[k] += 5 * um;
    const Learning after = learn(model(), other, {.every = 2 * an_hour});
    for (std::size_t k = 0; k <= row; ++k) {
      ASSERT_EQ(before.predicted[k], after.predicted[k]) << row << " moves " << k;
      ASSERT_TRUE(before.std[k] == after.std[k] ||
                  (std::isnan(before.std[k]) && std::isnan(after.std[k])))
          << row << " moves " << k;
    }
    if (row < 1800) {
      EXPECT_NE(before.predicted.back(), after.predicted.back()) << row;
    }
  }
}

/// A prediction does not know its own reading: without the last ones it is the same.
TEST(Learning, APredictionDoesNotUseItsOwnReading) {
  const record::Record truth = machine(1.1, 30);
  record::Record cut = truth;
  readings(cut).back() = unset;
  EXPECT_EQ(learn(model(), truth).predicted.back(), learn(model(), cut).predicted.back());
}

TEST(Learning, OneWildReadingIsNamedAndNotLearnt) {
  record::Record wild = sparse(machine(1.0, 30), 120), empty = wild;
  readings(wild)[840] += 100 * um;
  readings(empty)[840] = unset;
  const Learning l = learn(model(), wild), without = learn(model(), empty);
  EXPECT_EQ(l.predicted, without.predicted);
  ASSERT_THAT(l.readings, SizeIs(16));
  for (const OfferedReading& r : l.readings) EXPECT_EQ(r.learnt, r.row != 840) << r.row;
  EXPECT_TRUE(l.due.empty());
}

TEST(Learning, TwoReadingsThatAgreeMoveTheZeroAndAskForIdentification) {
  const record::Record truth =
      machine(1.0, 30, [](double t) { return t >= 14 * an_hour ? 100.0 : 0.0; });
  const Learning l = learn(model(), sparse(truth, 120));
  EXPECT_FALSE(l.readings[7].learnt);
  EXPECT_TRUE(l.readings[8].learnt);
  EXPECT_TRUE(l.readings[8].zeroed);
  EXPECT_NEAR(worst(l, truth, 961), 0.0, 0.1);
  ASSERT_THAT(l.due, SizeIs(1));
  EXPECT_EQ(l.due[0].row, 960U);
  EXPECT_THAT(l.due[0].reason, HasSubstr("the readings jump by 100 um"));
}

/// The probe reads once more, whatever the interval.
TEST(Learning, AWildReadingIsRepeatedAtOnce) {
  record::Record wild = machine(1.0, 30);
  readings(wild)[840] += 100 * um;
  const Learning l = learn(model(), wild, {.every = 2 * an_hour});
  ASSERT_THAT(l.readings, SizeIs(16));  // the last interval now ends behind the record
  EXPECT_FALSE(l.readings[7].learnt);
  EXPECT_EQ(l.readings[8].row, 841U);
  EXPECT_TRUE(l.readings[8].learnt);
  EXPECT_FALSE(l.readings[8].zeroed);
}

TEST(Learning, AFirstWildReadingIsGotOver) {
  record::Record truth = machine(1.0, 30), wild = sparse(truth, 120);
  readings(wild)[0] += 500 * um;
  EXPECT_NEAR(worst(learn(model(), wild), truth, 241), 0.0, 0.2);
}

TEST(Learning, AGainAtItsBoundAsksForIdentification) {
  Model m = model();
  m.tolerance = 2 * um;
  const Learning l = learn(m, machine(1.7, 60), {.every = 2 * an_hour});
  EXPECT_TRUE(l.gains[0].at_bound);
  EXPECT_DOUBLE_EQ(l.gains[0].value, 0.5);
  ASSERT_FALSE(l.due.empty());
  EXPECT_THAT(l.due.front().reason, HasSubstr("spindle has reached its bound"));
}

/// Something that the model knows nothing of: 3 um in steps of two hours, at random.
TEST(Learning, ReadingsThatStayTooFarOffAskForIdentification) {
  const auto jumps = [](double t) {
    const auto k = static_cast<unsigned>(t / (2 * an_hour));
    return 3.0 * ((k * 2654435761U >> 16U) % 2 == 0 ? 1.0 : -1.0);
  };
  Model m = model();
  const Learning l = learn(m, machine(1.0, 60, jumps), {.every = 2 * an_hour});
  ASSERT_FALSE(l.due.empty());
  EXPECT_THAT(l.due.back().reason, HasSubstr("8 consecutive readings have"));
  EXPECT_GT(l.level, 2.0);
  m.tolerance = 4 * um;
  EXPECT_TRUE(learn(m, machine(1.0, 60, jumps), {.every = 2 * an_hour}).due.empty());
}

/// What the model lacks here is a lag of half an hour; its range says how much that is worth.
TEST(Learning, FindsALagThatTheModelLacks) {
  MadeRecord made(60 * an_hour, 60);
  made.with("front_temperature_C", temperature);
  Model truth = model();
  truth.channels[0].sections.push_back({1 * um, 1800});
  std::vector<double> y(made.time.size());
  simulate(truth, Series(made.record), y);
  made.record.set(*truth.displacement, y);
  Model m = model();
  m.tolerance = 4 * um;
  const Learning blind = learn(m, made.record, {.every = an_hour});
  m.range = {{.column = m.channels[0].input.columns.front(),
              .name = "front_temperature_C",
              .lower = 14 + celsius_zero,
              .upper = 30 + celsius_zero}};
  const Learning l = learn(m, made.record, {.every = an_hour});
  ASSERT_THAT(blind.gains, SizeIs(1));
  ASSERT_THAT(l.gains, SizeIs(4));
  EXPECT_GT(l.gains[1].value, l.gains[1].std);
  EXPECT_LT(l.error.learnt, 0.7 * blind.error.learnt);
  EXPECT_LT(l.error.learnt, 0.5 * l.error.zeroed);
  // What is saved predicts the same, but for the share that nobody can save.
  std::vector<double> saved(made.time.size());
  simulate(l.model, Series(made.record), saved);
  EXPECT_NEAR(saved.back() / um, l.predicted.back() / um, 1.0);
  // Learning from there adds to the lags that are there now.
  EXPECT_LE(learn(l.model, made.record, {.every = an_hour}).model.channels[0].sections.size(),
            l.model.channels[0].sections.size() + 0U);
}

TEST(Learning, ANewRunHasAZeroOfItsOwnAndTheSameGains) {
  record::Record truth = machine(1.2, 40, [](double t) { return t >= 20 * an_hour ? 60.0 : 5.0; });
  std::vector<double> run(truth.rows());
  for (std::size_t k = 0; k < run.size(); ++k) run[k] = k >= 1200 ? 1.0 : 0.0;
  truth.runs = {"first", "second"};
  truth.set(record::run, run);
  // The second run begins from rest: made as such.
  std::vector<double> y(truth.rows());
  simulate(model(), Series(truth), y);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = 1.2 * y[k] + (k >= 1200 ? 60.0 : 5.0) * um;
  readings(truth) = y;
  const Learning l = learn(model(), truth, {.every = 2 * an_hour});
  EXPECT_TRUE(std::isnan(l.std[1200]));
  for (const OfferedReading& r : l.readings) EXPECT_TRUE(r.learnt) << r.row;
  EXPECT_NEAR(worst(l, truth, 1201), 0.0, 0.5);
  EXPECT_TRUE(l.due.empty());
}

/// What is said of the time after the record is what comes, if all stays as it was.
TEST(Learning, SaysWhenTheNextReadingIsDue) {
  MadeRecord made(40 * an_hour, 60);
  made.with("front_temperature_C", [](double t) { return temperature(std::min(t, 9 * an_hour)); });
  made.with("displacement_z_um", [](double) { return 0.0; });
  record::Record record = made.record;
  for (std::size_t k = 0; k < record.rows(); ++k)
    if (k % 60 != 0 || k > 720) readings(record)[k] = unset;
  std::vector<std::size_t> first(721);
  for (std::size_t k = 0; k < first.size(); ++k) first[k] = k;
  // No reading is refused: what is there, nothing at all, is the machine.
  Model m = model();
  m.channels[0].sections[0].gain = 0.05 * um;
  const Learning l = learn(m, record.picked(first));
  ASSERT_TRUE(std::isfinite(l.next_reading));
  ASSERT_GT(l.next_reading, 0.0);
  const Learning on = learn(m, record);
  const auto due = static_cast<std::size_t>(l.next_reading / 60.0);
  EXPECT_LE(on.std[720 + due], m.tolerance);
  EXPECT_GT(on.std[720 + due + 5], m.tolerance);
  EXPECT_NEAR(on.readings.back().good_for, l.next_reading, 300.0);
  EXPECT_EQ(on.next_reading, 0.0);
}

TEST(Learning, AWarmMachineIsLessSureAtItsBeginning) {
  const record::Record truth = machine(1.0, 10);
  Model m = model();
  const double cold = learn(m, truth, {.every = an_hour}).std[30];
  m.initial_state = InitialState::free;
  EXPECT_GT(learn(m, truth, {.every = an_hour}).std[30], 2.0 * cold);
}

TEST(Learning, NeedsAReading) {
  record::Record record = machine(1.0, 2);
  for (double& v : readings(record)) v = unset;
  EXPECT_THROW((void)learn(model(), record), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::correction
