#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "loop/loop.h"

// Other base models of a subject: a height that goes with a power of the place.
namespace raceway::fit {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Channel spot{.name = "spot_m", .words = "spot", .unit = "m"};
constexpr Channel rise{
    .name = "rise_m", .words = "rise", .unit = "m", .role = record::Role::measured};

/// y = foot + size x^power; what may be missing is a ripple.
struct Hill : Subject, Predictor {
  double power = 1.0;
  bool ripple = false;
  std::map<std::string, double> at{{"foot", 0.5}, {"size", 0.5}};
  const Record* rows = nullptr;
  std::vector<std::string> moved{};

  static Parameter number(const std::string& name, double value) {
    Parameter p{.name = name, .unit = "1", .start = value, .lower = -1e3, .upper = 1e3};
    if (name != "ripple.height") return p;
    p.plausible_lower = 0.01;
    p.plausible_upper = 10.0;
    p.neutral = 0.0;
    p.scale = 0.5;
    return p;
  }
  static std::shared_ptr<const Hill> of(double power) {
    auto hill = std::make_shared<Hill>();
    hill->power = power;
    return hill;
  }
  std::vector<Measured> measured() const override { return {{&rise}}; }
  void require(const Record&) const override {}
  std::vector<std::string> free() const override { return {"foot", "size"}; }
  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> list;
    for (const auto& [name, value] : at) list.push_back(number(name, value));
    return list;
  }
  std::vector<Candidate> candidates() const override {
    return {{"ripple", {number("ripple.height", 0.1)}}};
  }
  std::unique_ptr<Subject> with_values(std::span<const NamedValue> values) const override {
    auto copy = std::make_unique<Hill>(*this);
    for (const NamedValue& v : values) copy->at[v.name] = v.value;
    return copy;
  }
  std::unique_ptr<Subject> with_candidates(std::span<const std::string> ids) const override {
    for (const std::string& id : ids)
      if (id != "ripple") throw std::invalid_argument(id + ": unknown");
    return with_values(std::vector<NamedValue>{{"ripple.height", 0.1}});
  }
  std::vector<OtherBase> other_bases() const override {
    return {{.id = "law:steep", .words = "law = steep", .lacks = "the slope of the ground"},
            {.id = "law:cube", .words = "law = cube", .subject = of(3.0)},
            {.id = "law:square", .words = "law = square", .subject = of(2.0)}};
  }
  std::unique_ptr<Predictor> predictor(const Record& record, const std::vector<std::string>& names,
                                       const std::shared_ptr<const void>&) const override {
    auto copy = std::make_unique<Hill>(*this);
    copy->rows = &record, copy->moved = names;
    return copy;
  }
  void readings(std::span<const double> values, std::span<double> out) override {
    for (std::size_t k = 0; k < values.size(); ++k) at[moved[k]] = values[k];
    const double height = at.contains("ripple.height") ? at["ripple.height"] : 0.0;
    for (std::size_t i = 0; i < rows->rows(); ++i) {
      const double x = rows->value(spot, i);
      out[i] = at["foot"] + at["size"] * std::pow(x, power) + height * std::sin(3.0 * x);
    }
  }
};

/// Readings of 1 + 2 x^power + height sin(3 x), with noise of 0.1.
Record hill(double power, double height) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.1);
  std::vector<double> x, y;
  for (int i = 0; i < 60; ++i) {
    x.push_back(0.1 + 0.05 * i);
    y.push_back(1.0 + 2.0 * std::pow(x.back(), power) + height * std::sin(3.0 * x.back()) +
                noise(random));
  }
  Record record;
  record.source = "hill.csv";
  record.set(spot, x), record.set(rise, y);
  return record;
}

TEST(OtherBases, OneThatExplainsTheDataIsOfferedBesideTheVerdict) {
  const verdict::Diagnosis d = loop::diagnose(*Hill::of(1.0), hill(2.0, 0.0));
  EXPECT_EQ(d.verdict, verdict::Verdict::not_in_catalogue) << d.sentence;
  EXPECT_THAT(d.headline, HasSubstr("law = square explains these data"));
  EXPECT_THAT(d.sentence, HasSubstr("law = square explains these data"));
  EXPECT_THAT(d.sentence, HasSubstr("use it with: raceway add MODEL law:square"));
  ASSERT_THAT(d.other_bases, SizeIs(2));
  const verdict::OtherBaseTried& best = d.other_bases.front();
  EXPECT_EQ(best.id, "law:square");
  EXPECT_TRUE(best.explains);
  EXPECT_NEAR(best.parameters.at(1).value, 2.0, 0.1);
  EXPECT_NEAR(best.rmse.at(0), 0.1, 0.02);
  EXPECT_LT(best.rmse_held_out.at(0), 0.13);
  ASSERT_NE(d.given_other_base, nullptr);
  EXPECT_EQ(d.given_other_base->verdict, verdict::Verdict::nothing_missing);
  // Both count, and what could not be tried is told with the datum.
  EXPECT_EQ(d.candidates_tried, 1 + 2);
  EXPECT_NEAR(d.needed_gain, std::log(60.0) + 2.0 * std::log(3.0), 1e-12);
  EXPECT_THAT(d.not_testable,
              Contains(Field(&verdict::NotTestable::reason, HasSubstr("the slope of the ground"))));
}

TEST(OtherBases, GivenTheBetterOneTheVerdictNamesWhatIsMissingBesideIt) {
  const verdict::Diagnosis d = loop::diagnose(*Hill::of(1.0), hill(2.0, 1.0));
  ASSERT_NE(d.given_other_base, nullptr) << d.sentence;
  EXPECT_EQ(d.other_bases.front().id, "law:square");
  EXPECT_FALSE(d.other_bases.front().explains);
  EXPECT_EQ(d.given_other_base->verdict, verdict::Verdict::effect) << d.given_other_base->sentence;
  EXPECT_THAT(d.sentence, HasSubstr("With law = square the verdict is effect"));
}

TEST(OtherBases, AreNotTriedWhereAnEffectExplainsTheDataOrNothingIsMissing) {
  const verdict::Diagnosis effect = loop::diagnose(*Hill::of(2.0), hill(2.0, 1.0));
  EXPECT_EQ(effect.verdict, verdict::Verdict::effect) << effect.sentence;
  EXPECT_THAT(effect.other_bases, IsEmpty());
  EXPECT_EQ(effect.candidates_tried, 1);
  EXPECT_THAT(loop::diagnose(*Hill::of(2.0), hill(2.0, 0.0)).other_bases, IsEmpty());
}

TEST(OtherBases, AreTakenByAddByTheRulesOfEffects) {
  const std::vector<std::string> square{"law:square"}, cube{"law:cube"}, steep{"law:steep"};
  const verdict::AddResult taken = loop::add(*Hill::of(1.0), square, hill(2.0, 0.0));
  EXPECT_FALSE(taken.refused) << taken.reason;
  EXPECT_NEAR(taken.channels.at(0).after.rmse, 0.1, 0.02);
  ASSERT_THAT(taken.calibration.parameters, SizeIs(2));
  EXPECT_NEAR(taken.calibration.parameters.at(1).value, 2.0, 0.1);
  EXPECT_NEAR(taken.gain, loop::diagnose(*Hill::of(1.0), hill(2.0, 0.0)).other_bases.at(0).gain,
              1e-6);
  // The one that the data are made with is no better by another.
  EXPECT_TRUE(loop::add(*Hill::of(2.0), cube, hill(2.0, 0.0)).refused);
  EXPECT_THROW((void)loop::add(*Hill::of(1.0), steep, hill(2.0, 0.0)), std::invalid_argument);
  EXPECT_THROW((void)loop::add(*Hill::of(1.0), std::vector<std::string>{"law:square", "ripple"},
                               hill(2.0, 0.0)),
               std::invalid_argument);
}

}  // namespace
}  // namespace raceway::fit
