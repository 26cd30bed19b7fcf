#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "loop/loop.h"

// What makes a verdict weaker than its fit: on a straight line that may lack a curve.
namespace raceway::fit {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr Channel place{.name = "place_m", .words = "place", .unit = "m"};
constexpr Channel height{
    .name = "height_m", .words = "height", .unit = "m", .role = record::Role::measured};
constexpr Channel deviation{
    .name = "std_m", .unit = "m", .role = record::Role::deviation, .of = "height_m"};

/// y = offset + slope x + bend(c) x², with the slope not below zero.
struct Line : Subject, Predictor {
  std::function<double(double)> bend = [](double c) { return c; };
  std::map<std::string, double> at{{"offset", 0.5}, {"slope", 0.5}};
  bool empirical = false;
  const Record* rows = nullptr;
  std::vector<std::string> moved{};

  static Parameter number(const std::string& name, double value) {
    Parameter p{.name = name, .unit = "1", .start = value, .lower = 0.0, .upper = 1e12};
    if (name == "offset") p.lower = -1e12;
    if (name != "curve.c") return p;
    p.plausible_lower = 0.01;
    p.plausible_upper = 1.0;
    p.neutral = 0.0;
    p.scale = 0.1;
    return p;
  }
  std::vector<Measured> measured() const override { return {{&height}}; }
  void require(const Record&) const override {}
  std::vector<std::string> free() const override { return {"offset", "slope"}; }
  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> list;
    for (const auto& [name, value] : at) list.push_back(number(name, value));
    return list;
  }
  std::vector<Candidate> candidates() const override {
    return {{.id = "curve", .parameters = {number("curve.c", 0.1)}, .empirical = empirical}};
  }
  std::unique_ptr<Subject> with_values(std::span<const NamedValue> values) const override {
    auto copy = std::make_unique<Line>(*this);
    for (const NamedValue& v : values) copy->at[v.name] = v.value;
    return copy;
  }
  std::unique_ptr<Subject> with_candidates(std::span<const std::string>) const override {
    return with_values(std::vector<NamedValue>{{"curve.c", 0.1}});
  }
  std::unique_ptr<Predictor> predictor(const Record& record, const std::vector<std::string>& names,
                                       const std::shared_ptr<const void>&) const override {
    auto copy = std::make_unique<Line>(*this);
    copy->rows = &record, copy->moved = names;
    return copy;
  }
  void readings(std::span<const double> values, std::span<double> out) override {
    for (std::size_t k = 0; k < values.size(); ++k) at[moved[k]] = values[k];
    const double b = at.contains("curve.c") ? bend(at["curve.c"]) : 0.0;
    for (std::size_t i = 0; i < rows->rows(); ++i) {
      const double x = rows->value(place, i);
      out[i] = at["offset"] + at["slope"] * x + b * x * x;
    }
  }
};

Record measured(const std::vector<double>& x, const std::vector<double>& y,
                const std::vector<double>& std) {
  Record record;
  record.source = "line.csv";
  record.set(place, x);
  record.set(height, y);
  record.set(deviation, std);
  return record;
}

/// 60 readings of y(x) from 0 to 3, with their noise.
Record readings(const std::function<double(double)>& y, double noise) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss(0.0, noise);
  std::vector<double> x, read;
  for (int i = 0; i < 60; ++i) {
    x.push_back(0.05 * (i + 1));
    read.push_back(y(x.back()) + gauss(random));
  }
  return measured(x, read, std::vector<double>(x.size(), noise));
}

TEST(VerdictDoubt, NoneWhereTheCurveIsThere) {
  const verdict::Diagnosis d =
      loop::diagnose(Line(), readings([](double x) { return 1.0 + x + 0.2 * x * x; }, 0.02));
  EXPECT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_NEAR(d.effects[0].parameters[0].value, 0.2, 0.02);
}

TEST(VerdictDoubt, AShapeWithoutALawIsOnlyActedLike) {
  Line line;
  line.empirical = true;
  const verdict::Diagnosis d =
      loop::diagnose(line, readings([](double x) { return 1.0 + x + 0.2 * x * x; }, 0.02));
  EXPECT_EQ(d.verdict, verdict::Verdict::effect_like) << d.sentence;
  EXPECT_TRUE(d.effects.at(0).in_verdict);
  EXPECT_THAT(d.sentence, HasSubstr("acts like curve, an empirical shape without a physical law"));
}

TEST(VerdictDoubt, ABaseParameterAtItsBoundIsNamed) {
  const verdict::Diagnosis d =
      loop::diagnose(Line(), readings([](double x) { return 1.0 - 0.02 * x + 0.2 * x * x; }, 0.02));
  EXPECT_EQ(d.verdict, verdict::Verdict::effect_like) << d.sentence;
  EXPECT_THAT(d.sentence, HasSubstr("acts like curve, but only with slope at 0, the limit of its"));
}

/// Most of the curve that the law can give, at any size however large.
TEST(VerdictDoubt, ASizeThatRunsAwayIsNoFit) {
  Line line;
  line.bend = [](double c) { return 0.2 * c / (1.0 + c); };
  const verdict::Diagnosis d =
      loop::diagnose(line, readings([](double x) { return 1.0 + x + 0.201 * x * x; }, 0.02));
  EXPECT_EQ(d.verdict, verdict::Verdict::not_in_catalogue) << d.sentence;
  EXPECT_THAT(texts(d.messages), Contains(HasSubstr("the fit with curve diverges to c = ")));
}

/// The few readings of most of the error count least: certain, and worse to the eye.
TEST(VerdictDoubt, WhatRaisesTheErrorDoesNotLead) {
  Record record = readings([](double x) { return 1.0 + x + 0.05 * x * x; }, 0.005);
  std::vector<double> x(record.values(place).begin(), record.values(place).end());
  std::vector<double> y(record.values(height).begin(), record.values(height).end());
  std::vector<double> std(x.size(), 0.005);
  for (int i = 0; i < 6; ++i) {
    x.push_back(10.0 + i);
    y.push_back(1.0 + 1.15 * x.back());
    std.push_back(20.0);
  }
  record = measured(x, y, std);
  const verdict::Diagnosis d = loop::diagnose(Line(), record);
  EXPECT_EQ(d.verdict, verdict::Verdict::effect_like) << d.sentence;
  EXPECT_GT(d.channels[0].rmse_after, d.channels[0].rmse_before);
  EXPECT_THAT(d.sentence, HasSubstr("acts like curve, but the error rises from "));
}

}  // namespace
}  // namespace raceway::fit
