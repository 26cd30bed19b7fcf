#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <random>

#include "loop/loop.h"

// The loop on a simulation that may be asked for but dozens of times: two lags in a row, read at
// both, and heat that it lacks.
namespace raceway::fit {
namespace {

constexpr Channel drive_voltage{.name = "drive_V", .unit = "V"}, sun{.name = "sun_W", .unit = "W"};
constexpr Channel first{
    .name = "first_K", .words = "first", .unit = "K", .role = record::Role::measured};
constexpr Channel second{.name = "second_um",
                         .words = "second",
                         .unit = "um",
                         .factor = um,
                         .role = record::Role::measured};
constexpr std::size_t row_count = 480;
constexpr double minute = 60.0;

///   600 s dx/dt = gain u + heat u + 5 sun s - x,   3000 s dy/dt = loss x + leak - y
///   first = x,   second = y um
/// `square` adds u² in place of u; `strange`: heat that follows no input. With `ledge` above 0
/// instead: first = (3 gain + heat) u,   second = 0.3 (gain - 3) (9 - gain) u um.
struct Chain : Subject {
  std::map<std::string, double> at{{"gain", 3.0},        {"heat.W", 0.0}, {"sun.W", 0.0},
                                   {"loss.factor", 1.0}, {"leak.K", 0.0}, {"strange", 0.0},
                                   {"ledge", 0.0}};
  std::vector<std::string> on{};
  double floor_K = 0.3, floor_um = 0.3 * um;
  std::shared_ptr<std::atomic<int>> simulations = std::make_shared<std::atomic<int>>(0);

  std::vector<Measured> measured() const override {
    return {{.channel = &first, .model_error = floor_K, .approximate = true},
            {.channel = &second, .model_error = floor_um, .approximate = true}};
  }
  void require(const Record&) const override {}
  bool has_memory() const override { return true; }
  bool approximates() const override { return true; }
  bool is_costly() const override { return true; }
  std::vector<std::string> free() const override { return {"gain"}; }
  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> list;
    const auto add = [&](const char* name, double lower, double upper, double neutral) {
      const double v = at.at(name);
      list.push_back({.name = name,
                      .unit = "1",
                      .start = v,
                      .value = v,
                      .initial = v,
                      .lower = lower,
                      .upper = upper,
                      .neutral = neutral});
    };
    add("gain", 0.5, 20.0, unset);
    add("heat.W", 0.0, 20.0, 0.0);
    add("sun.W", 0.0, 20.0, 0.0);
    add("loss.factor", 0.05, 20.0, 1.0);
    add("leak.K", -10.0, 10.0, 0.0);
    return list;
  }
  std::vector<Candidate> candidates() const override {
    std::vector<Candidate> list;
    for (const Parameter& p : parameters())
      if (const std::size_t dot = p.name.find('.'); dot != std::string::npos)
        if (const std::string id = p.name.substr(0, dot);
            std::find(on.begin(), on.end(), id) == on.end())
          list.push_back({.id = id, .parameters = {p}});
    return list;
  }
  std::unique_ptr<Subject> with_values(std::span<const NamedValue> values) const override {
    auto copy = std::make_unique<Chain>(*this);
    for (const NamedValue& v : values) copy->at[v.name] = v.value;
    return copy;
  }
  std::unique_ptr<Subject> with_candidates(std::span<const std::string> ids) const override {
    auto copy = std::make_unique<Chain>(*this);
    copy->on.insert(copy->on.end(), ids.begin(), ids.end());
    return copy;
  }
  std::vector<Blocking> blockings(const Record& record) const override {
    Blocking eight{.variable = "time", .blocks = 8};
    for (std::size_t k = 0; k < record.rows(); ++k)
      eight.block.push_back(static_cast<int>(k * 8 / record.rows()));
    return {eight};
  }
  std::unique_ptr<Predictor> predictor(const Record& record, const std::vector<std::string>& names,
                                       const std::shared_ptr<const void>&) const override;
};

struct Simulation : Predictor {
  Chain of;
  const Record& record;
  std::vector<std::string> names;
  Simulation(Chain chain, const Record& r, std::vector<std::string> n)
      : of(std::move(chain)), record(r), names(std::move(n)) {}
  void readings(std::span<const double> values, std::span<double> out) override {
    ++*of.simulations;
    for (std::size_t k = 0; k < values.size(); ++k) of.at[names[k]] = values[k];
    double x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < record.rows(); ++i) {
      const double u = record.value(drive_voltage, i), s = record.value(sun, i);
      if (of.at["ledge"] > 0.0) {
        const double gain = of.at["gain"];
        out[i] = (3.0 * gain + of.at["heat.W"]) * u;
        out[record.rows() + i] = 0.3 * (gain - 3.0) * (9.0 - gain) * u * um;
        continue;
      }
      const double odd = of.at["strange"] * std::sin(0.05 * static_cast<double>(i));
      x += minute / 600.0 *
           (of.at["gain"] * u + of.at["heat.W"] * u * u + 5.0 * of.at["sun.W"] * s + odd - x);
      y += minute / 3000.0 * (of.at["loss.factor"] * x + of.at["leak.K"] - y);
      out[i] = x;
      out[record.rows() + i] = y * um;
    }
  }
};

std::unique_ptr<Predictor> Chain::predictor(const Record& record,
                                            const std::vector<std::string>& names,
                                            const std::shared_ptr<const void>&) const {
  (void)find_parameters(*this, names);
  return std::make_unique<Simulation>(*this, record, names);
}

Record recorded_with(const std::map<std::string, double>& truth) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.1);
  std::vector<double> u, s, t;
  constexpr double levels[] = {0.0, 2.0, 1.0, 3.0, 0.5, 2.5, 0.0, 1.5};
  for (std::size_t k = 0; k < row_count; ++k) {
    u.push_back(levels[k / 60]);
    s.push_back(k / 90 % 2 ? 0.2 : 1.0);
    t.push_back(minute * static_cast<double>(k + 1));
  }
  Record record;
  record.source = "made";
  record.set(record::time, t), record.set(drive_voltage, u), record.set(sun, s);
  Chain chain;
  for (const auto& [name, value] : truth) chain.at[name] = value;
  std::vector<double> y = predict(chain, record);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += noise(random) * (i < row_count ? 1.0 : um);
  record.set(first, {y.begin(), y.begin() + row_count});
  record.set(second, {y.begin() + row_count, y.end()});
  return record;
}

TEST(CostlySubject, NothingIsMissingWithinItsOwnCoarseness) {
  const Record record = recorded_with({{"gain", 2.7}});
  Chain chain;
  const verdict::Diagnosis d = loop::diagnose(chain, record);
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  ASSERT_EQ(d.channels.size(), 2u);
  // What counts is the model's coarseness together with the noise.
  EXPECT_NEAR(d.channels[0].tolerance, std::hypot(0.3, 0.1), 0.01);
  EXPECT_NEAR(d.channels[1].tolerance / um, std::hypot(0.3, 0.1), 0.01);
  EXPECT_NEAR(d.channels[0].rmse_held_out_before, 0.1, 0.02);
  EXPECT_NEAR(d.base.empty() ? 2.7 : d.base[0].value, 2.7, 0.05);
}

TEST(CostlySubject, TheHiddenHeatIsFoundWithItsSize) {
  const Record record = recorded_with({{"gain", 2.5}, {"sun.W", 0.6}});
  Chain chain;
  const verdict::Diagnosis d = loop::diagnose(chain, record);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "sun");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 0.6, 0.02);
  ASSERT_EQ(d.effects.front().rmse.size(), 2u);
  EXPECT_LT(d.effects.front().rmse_held_out[1], 0.15 * um);
}

TEST(CostlySubject, AFactorFarFromOneIsFoundByTheOtherChannelAlone) {
  const Record record = recorded_with({{"gain", 2.5}, {"loss.factor", 0.15}});
  const verdict::Diagnosis d = loop::diagnose(Chain(), record);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "loss");
  EXPECT_NEAR(d.effects.front().parameters.front().value, 0.15, 0.01);
}

TEST(CostlySubject, HeatThatFollowsNoInputHasNoName) {
  const Record record = recorded_with({{"gain", 2.5}, {"strange", 8.0}});
  const verdict::Diagnosis d = loop::diagnose(Chain(), record);
  EXPECT_TRUE(d.verdict == verdict::Verdict::not_in_catalogue ||
              d.verdict == verdict::Verdict::effect_like)
      << d.sentence;
}

TEST(CostlySubject, AVerdictTakesDozensOfSimulations) {
  const Record record = recorded_with({{"gain", 2.5}, {"sun.W", 0.6}});
  const Chain chain;
  (void)loop::diagnose(chain, record);
  EXPECT_LT(*chain.simulations, 100);
}

TEST(CostlySubject, AddAndCalibrateKeepWhatADiagnosisFound) {
  const Record record = recorded_with({{"gain", 2.5}, {"sun.W", 0.6}});
  const verdict::Diagnosis d = loop::diagnose(Chain(), record);
  const verdict::AddResult added = loop::add(Chain(), std::vector<std::string>{"sun"}, record);
  ASSERT_FALSE(added.refused) << added.reason;
  ASSERT_EQ(added.channels.size(), 2u);
  EXPECT_LT(added.channels[0].rmse_held_out_after, 0.4 * added.channels[0].rmse_held_out_before);
  const Parameter& size = added.calibration.parameters.at(1);
  EXPECT_NEAR(size.value, d.effects.front().parameters.front().value, 0.2 * size.std);
  EXPECT_NEAR(size.value, 0.6, 4.0 * size.std);
  const verdict::Calibration again = loop::calibrate(*added.calibration.subject, record);
  EXPECT_NEAR(again.parameters.front().value, added.calibration.parameters.front().value, 0.002);
  EXPECT_EQ(again.channels.size(), 2u);
}

// The gain alone follows the heat to 6.4, from where less heat than none would be better; from
// where the gain began the heat is found.
TEST(CostlySubject, HeatThatItsGainHasHiddenIsFoundFromWhereTheGainBegan) {
  const Record record = recorded_with({{"gain", 3.0}, {"heat.W", 10.0}, {"ledge", 1.0}});
  Chain chain;
  chain.at["ledge"] = 1.0;
  EXPECT_NEAR(loop::calibrate(chain, record).parameters.front().value, 6.4, 0.1);
  const verdict::AddResult added = loop::add(chain, std::vector<std::string>{"heat"}, record);
  ASSERT_FALSE(added.refused) << added.reason;
  EXPECT_NEAR(added.calibration.parameters.at(0).value, 3.0, 0.05);
  EXPECT_NEAR(added.calibration.parameters.at(1).value, 10.0, 0.1);
  const verdict::Diagnosis d = loop::diagnose(chain, record);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "heat");
}

TEST(CostlySubject, WhatIsWithinItsCoarsenessIsNotAdded) {
  const Record record = recorded_with({{"gain", 2.5}});
  const verdict::AddResult added = loop::add(Chain(), std::vector<std::string>{"sun"}, record);
  EXPECT_TRUE(added.refused);
}

TEST(CostlySubject, AChannelThatWasNotReadIsLeftOut) {
  Record record = recorded_with({{"gain", 2.5}, {"sun.W", 0.6}});
  for (double& v : record.find(second)->values) v = unset;
  const verdict::Diagnosis d = loop::diagnose(Chain(), record);
  ASSERT_EQ(d.channels.size(), 1u);
  EXPECT_EQ(d.channels[0].channel(), first);
}

}  // namespace
}  // namespace raceway::fit
