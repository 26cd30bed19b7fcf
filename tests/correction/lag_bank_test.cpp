#include "correction/lag_bank.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "correction/alignment.h"
#include "fit/problem.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::HasSubstr;

/// Two bodies behind one speed, as four sensors tell of them that go with both. What is true is no
/// bank: time constants of 2500 s and 9000 s, 1.5 um/K and -0.8 um/K.
MadeRecord many_sensors(double noise) {
  MadeRecord made(110000, 60);
  std::vector<double> fast(made.time.size()), slow(made.time.size()), y(made.time.size());
  const auto heat = [](double t) { return stepped_speed(t, 9000) / 1000.0; };
  for (std::size_t k = 1; k < made.time.size(); ++k) {
    const double before = heat(made.time[k - 1]), step = 60.0;
    fast[k] = fast[k - 1] + (1.0 - std::exp(-step / 2500.0)) * (before - fast[k - 1]);
    slow[k] = slow[k - 1] + (1.0 - std::exp(-step / 9000.0)) * (before - slow[k - 1]);
  }
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal(0.0, noise);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = 1.5 * fast[k] - 0.8 * slow[k] + normal(engine);
  const auto mixed = [&](double a, double b) {
    return [&, a, b](double t) {
      const auto k = static_cast<std::size_t>(std::lround(t / 60.0));
      return 20.0 + a * fast[k] + b * slow[k];
    };
  };
  made.with("a_temperature_C", mixed(1.0, 0.1))
      .with("b_temperature_C", mixed(0.4, 0.7))
      .with("c_temperature_C", mixed(0.1, 0.9))
      .with("d_temperature_C", mixed(0.6, 0.6))
      .with("speed_rpm", [](double t) { return stepped_speed(t, 9000); })
      .with("displacement_z_um",
            [&](double t) { return y[static_cast<std::size_t>(std::lround(t / 60.0))]; });
  return made;
}

Model bare_bank() { return {.displacement = record::series_channel("displacement_z_um")}; }

std::vector<const Channel*> inputs_of_all(const record::Record& record) {
  std::vector<const Channel*> list;
  for (const record::Column& c : record.columns)
    if (c.channel->is_input()) list.push_back(c.channel);
  return list;
}

TEST(LagBank, PredictsWhatLiesAheadOfMachinesThatAreNoBank) {
  const MadeRecord made = many_sensors(0.05);
  const Identification found =
      identify_lag_bank(bare_bank(), made.record, {.inputs = inputs_of_all(made.record)});
  ASSERT_EQ(found.ahead.size(), 6U);
  for (const AheadError& e : found.ahead) EXPECT_LT(e.rms, 0.25e-6) << e.from;
  EXPECT_LT(found.metrics.rms, 0.1e-6);
  double shares = 0.0;
  for (const StrengthTried& t : found.strengths) shares += t.share;
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

TEST(LagBank, EndsWhereItIsTold) {
  const MadeRecord made = many_sensors(0.3);
  LagBankOptions options{.inputs = inputs_of_all(made.record)};
  options.cancelled = [] { return true; };
  EXPECT_THROW((void)identify_lag_bank(bare_bank(), made.record, options), fit::Cancelled);
}

/// The gains of the model are those that were judged: run over the record it leaves what was said.
TEST(LagBank, ItsModelIsWhatWasFitted) {
  const MadeRecord made = many_sensors(0.3);
  const Identification found =
      identify_lag_bank(bare_bank(), made.record, {.inputs = inputs_of_all(made.record)});
  const auto subject = aligned(found.model, made.record, Zero::none);
  const Metrics m =
      metrics(made.record.values(*found.model.displacement), fit::predict(*subject, made.record));
  EXPECT_NEAR(m.rms / found.metrics.rms, 1.0, 1e-3);
  EXPECT_LT(std::abs(m.residue_max + m.residue_min), 1e-6);
}

/// What comes later is not seen: readings after the last cut do not move what a fit up to an
/// earlier one leaves before them.
TEST(LagBank, AFitUpToACutKnowsNothingOfWhatFollows) {
  const MadeRecord made = many_sensors(0.05);
  MadeRecord other = many_sensors(0.05);
  std::vector<double>& y = other.record.find(*record::series_channel("displacement_z_um"))->values;
  for (std::size_t k = y.size() * 95 / 100; k < y.size(); ++k) y[k] += 40e-6;
  const LagBankOptions options{.inputs = inputs_of_all(made.record)};
  const Identification a = identify_lag_bank(bare_bank(), made.record, options),
                       b = identify_lag_bank(bare_bank(), other.record, options);
  // 40 um on 5 % of all rows are 40 sqrt(0.05/0.41) um of the rows after the first cut.
  const double expected = 40e-6 * std::sqrt(0.05 / 0.41);
  EXPECT_NEAR(b.ahead.front().rms / expected, 1.0, 0.03);
  EXPECT_LT(a.ahead.front().rms, 0.25e-6);
}

TEST(LagBank, TakesTimeConstantsAsTheyAreGiven) {
  const MadeRecord made = many_sensors(0.05);
  const Identification found = identify_lag_bank(
      bare_bank(), made.record,
      {.inputs = {record::series_channel("a_temperature_C"), record::series_channel("speed_rpm")},
       .time_constants = {0.0, 2000.0, 8000.0}});
  ASSERT_EQ(found.model.channels.size(), 3U);  // the speed twice
  for (const DrivenChannel& c : found.model.channels) {
    ASSERT_EQ(c.sections.size(), 2U);
    EXPECT_EQ(c.sections[1].time_constant, 8000.0);
  }
  EXPECT_EQ(found.model.channels[1].feedthrough, 0.0);
  EXPECT_EQ(found.model.channels[2].input.exponent, 1.5);
  EXPECT_THAT(found.model.free, testing::ElementsAre("offset"));
}

std::string refusal_of_bank(const Model& model, const record::Record& record,
                            const LagBankOptions& options) {
  try {
    (void)identify_lag_bank(model, record, options);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "none";
}

TEST(LagBank, RefusesWhatItCannotDo) {
  const MadeRecord made = many_sensors(0.05);
  const LagBankOptions all{.inputs = inputs_of_all(made.record)};
  Model with_channel = bare_bank();
  with_channel.channels.push_back({.name = "a"});
  EXPECT_THAT(refusal_of_bank(with_channel, made.record, all),
              HasSubstr("remove them from the model"));
  Model warm = bare_bank();
  warm.initial_state = InitialState::free;
  EXPECT_THAT(refusal_of_bank(warm, made.record, all), HasSubstr("starts from a machine at rest"));
  EXPECT_THAT(refusal_of_bank(bare_bank(), made.record, {}), HasSubstr("needs input columns"));
  LagBankOptions negative = all;
  negative.time_constants = {-1.0};
  EXPECT_THAT(refusal_of_bank(bare_bank(), made.record, negative), HasSubstr("must be 0 or more"));
  MadeRecord short_one(600, 60);
  short_one.with("a_temperature_C", [](double t) { return 20 + t / 100; })
      .with("displacement_z_um", [](double t) { return t / 100; });
  EXPECT_THAT(
      refusal_of_bank(bare_bank(), short_one.record, {.inputs = inputs_of_all(short_one.record)}),
      HasSubstr("too few"));
}

}  // namespace
}  // namespace raceway::correction
