#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "loop/loop.h"

// The loop, linked with record/ alone, on a lag read at two places with an input that it lacks.
namespace raceway::fit {

constexpr Channel drive{.name = "drive_V"}, wind{.name = "wind_W"};
constexpr Channel near{.name = "near_K", .role = record::Role::measured};
constexpr Channel far{.name = "far_K", .role = record::Role::measured};
/// dx/dt = (gain u - x)/tau;  near = x + leak v,  far = x/2 + 2 leak v
struct Lag : Subject, Predictor {
  std::map<std::string, double> at{{"gain", 3.0}, {"tau", 20.0}};
  const Record* rows = nullptr;
  std::vector<std::string> moved{};
  static Parameter number(const std::string& name, double value) {
    return {.name = name, .unit = "1", .start = value, .lower = 0, .upper = 99, .neutral = 0};
  }
  std::vector<Measured> measured() const override { return {{&near}, {&far}}; }
  void require(const Record&) const override {}
  bool has_memory() const override { return true; }
  std::vector<std::string> free() const override { return {"gain", "tau"}; }
  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> list;
    for (const auto& [name, value] : at) list.push_back(number(name, value));
    return list;
  }
  std::vector<Candidate> candidates() const override { return {{"leak", {number("leak.c", 0.1)}}}; }
  std::unique_ptr<Subject> with_values(std::span<const NamedValue> values) const override {
    auto copy = std::make_unique<Lag>(*this);
    for (const NamedValue& v : values) copy->at[v.name] = v.value;
    return copy;
  }
  std::unique_ptr<Subject> with_candidates(std::span<const std::string>) const override {
    return with_values(std::vector<NamedValue>{{"leak.c", 0.1}});
  }
  std::unique_ptr<Predictor> predictor(const Record& record, const std::vector<std::string>& names,
                                       const std::shared_ptr<const void>&) const override {
    auto copy = std::make_unique<Lag>(*this);
    copy->rows = &record, copy->moved = names;
    return copy;
  }
  void readings(std::span<const double> values, std::span<double> out) override {
    for (std::size_t k = 0; k < values.size(); ++k) at[moved[k]] = values[k];
    double x = 0.0;
    for (std::size_t i = 0, n = rows->rows(); i < n; ++i) {
      const double v = at.contains("leak.c") ? at["leak.c"] * rows->value(wind, i) : 0.0;
      x += (1.0 - std::exp(-1.0 / at["tau"])) * (at["gain"] * rows->value(drive, i) - x);
      out[i] = x + v, out[n + i] = 0.5 * x + 2.0 * v;
    }
  }
};

TEST(ToySubject, GoesThroughTheWholeLoop) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::vector<double> u, v;
  for (int i = 0; i < 240; ++i) u.push_back(i / 40 % 2 ? 1.0 : 4.0), v.push_back(std::sin(0.2 * i));
  Record record;
  record.set(drive, u), record.set(wind, v);
  const NamedValue truth[] = {{"gain", 2.0}, {"tau", 12.0}, {"leak.c", 0.3}};
  std::vector<double> y = predict(*Lag().with_values(truth), record);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = i % 3 || i < 240 ? y[i] + noise(random) : unset;
  record.set(near, {y.begin(), y.begin() + 240}), record.set(far, {y.begin() + 240, y.end()});
  EXPECT_EQ(verdict::compare(Lag(), record).at(1).rows, 160);  // an empty cell: not read then
  EXPECT_TRUE(loop::calibrate(Lag(), record).converged());
  const verdict::Diagnosis diagnosis = loop::diagnose(Lag(), record);
  ASSERT_EQ(diagnosis.verdict, verdict::Verdict::effect) << diagnosis.sentence;
  const double size = diagnosis.effects.at(0).parameters.at(0).value;
  EXPECT_NEAR(size, 0.3, 0.01);
  const verdict::AddResult added = loop::add(Lag(), std::vector<std::string>{"leak"}, record);
  EXPECT_TRUE(!added.refused && added.calibration.parameters.at(2).value == size) << added.reason;
}

}  // namespace raceway::fit
