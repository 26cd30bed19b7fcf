#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/hidden_effect/bars.h"

namespace hidden_effect {
namespace {

using testing::HasSubstr;

// A small study with fixed seeds. Its limits are those that a share of so few cases may still have
// if the bar itself is met; scripts/study measures the bars.

/// `kind`: of block `real` those with this in their name.
std::vector<Outcome> small_study(std::string_view block, int seeds, std::size_t every = 1,
                                 std::string_view kind = "") {
  const std::vector<Trial> all = trials(block, seeds);
  std::vector<Trial> some;
  for (std::size_t i = 0; i < all.size(); i += every)
    if (all[i].kind.find(kind) != all[i].kind.npos) some.push_back(all[i]);
  std::vector<Outcome> outcomes = judge_all(some, [](std::size_t) {});
  for (const Outcome& o : outcomes) EXPECT_NE(o.answer.verdict, "failed") << o.answer.message;
  return outcomes;
}

/// The bars of the study that these outcomes bear on, and whether they could still be met.
void expect_within_reach(const std::vector<Outcome>& outcomes,
                         const std::vector<std::string>& numbers) {
  int held = 0;
  for (const Bar& bar : bars(outcomes)) {
    if (bar.trials == 0 || std::isnan(bar.interval.lower)) continue;
    if (std::find(numbers.begin(), numbers.end(), bar.number) == numbers.end()) continue;
    ++held;
    if (bar.at_least)
      EXPECT_GE(bar.interval.upper, bar.must) << bar.what << ": " << bar.measured << " %";
    else
      EXPECT_LE(bar.interval.lower, bar.must) << bar.what << ": " << bar.measured << " %";
  }
  EXPECT_GT(held, 0);
}

TEST(SmallStudy, NothingHiddenIsSeldomCalledSomething) {
  expect_within_reach(small_study("null", 1), {"1"});
}

TEST(SmallStudy, StructuredNoiseIsSeldomCalledSomething) {
  expect_within_reach(small_study("noise", 1), {"2"});
}

TEST(SmallStudy, EffectsOfTheCatalogueAreFoundOnAFactorialPlan) {
  expect_within_reach(small_study("factorial", 1), {"3", "4", "5", "7"});
}

TEST(SmallStudy, EffectsOfTheCatalogueAreNotTakenForOthersOnARunUp) {
  expect_within_reach(small_study("run-up", 1, 2), {"5", "6", "7"});
}

TEST(SmallStudy, EffectsOutsideTheCatalogueAreCalledSo) {
  expect_within_reach(small_study("outside", 1), {"10", "11", "14b"});
}

TEST(SmallStudy, OtherFormsAreTakenForTheirFamily) {
  const std::vector<Outcome> outcomes = small_study("forms", 1);
  expect_within_reach(outcomes, {"13"});
  // Bar 12 wants the right family ranked first in 95 %; docs/study.md has the 92 % that are reached
  // and why. Here: none wrong, and no fewer first than that.
  int first = 0;
  for (const Outcome& o : outcomes) {
    EXPECT_FALSE(o.wrong()) << o.trial.setup.hidden.front().id;
    first += o.right_first() ? 1 : 0;
  }
  EXPECT_GE(wilson(first, static_cast<int>(outcomes.size())).upper, 0.90);
}

TEST(SmallStudy, TwoEffectsAreFoundTogether) {
  expect_within_reach(small_study("two", 1, 2), {"14"});
}

// The true torque is that of formulas and integrals of the study's own (contact_truth.h).
TEST(SmallStudy, EffectsBesideTheContactLawAreFound) {
  expect_within_reach(small_study("contact", 1, 3), {"c1", "c2", "c3"});
}

TEST(SmallStudy, RigsAsPeopleBuildThemAreSeldomMisjudged) {
  for (const std::string_view kind :
       {"16 rows", "8 rows", "11 rows", "run per load, 3 %", "oil card", "60 % of the rise",
        "sensor 5 K low", "three effects", "F read as C", "kgf read as N", "law palmgren, is skf",
        "preload grows"}) {
    SCOPED_TRACE(kind);
    expect_within_reach(small_study("real", 4, 1, kind), {"r"});
  }
}

TEST(SmallStudy, ALawOfNoCatalogueIsDescribedByItsExponents) {
  const std::vector<Outcome> outcomes = small_study("real", 2, 1, "of ours");
  expect_within_reach(outcomes, {"r"});
  for (const Outcome& o : outcomes) {
    SCOPED_TRACE(o.trial.kind);
    const std::vector<std::string>& with_powers = o.answer.names_given_it;
    const bool constant = o.trial.kind.find("constant") != std::string::npos;
    // Fitted exponents can hide a constant in addition to a law of ball loads. The bars count how
    // often.
    if (!constant || o.trial.kind.find("ball loads") == std::string::npos)
      EXPECT_EQ(with_powers.empty(), !constant) << o.answer.sentence;
    EXPECT_THAT(o.answer.sentence, HasSubstr(constant ? "powers (fitted exponents) fits better"
                                                      : "powers (fitted exponents) describes"));
  }
}

TEST(SmallStudy, TheAnswerDoesNotDependOnHowTheRigIsWrittenDown) {
  for (const Outcome& o : small_study("invariance", 1, 2)) EXPECT_EQ(o.changed_by, "");
}

// What the study itself must be able to see: with these its table would be worth nothing.
TEST(Bars, WilsonsIntervalIsThatOfTheBooks) {
  const Interval i = wilson(8, 10);
  EXPECT_NEAR(i.lower, 0.4902, 1e-4);
  EXPECT_NEAR(i.upper, 0.9433, 1e-4);
  EXPECT_EQ(wilson(0, 20).lower, 0.0);
}

TEST(Bars, WrongAnswersAreCountedAsWrong) {
  Outcome o{};
  o.trial.block = "factorial";
  o.trial.setup.hidden = {{.id = "lubricant-drag"}};
  o.accepted = {{"lubricant-drag", "windage"}};
  o.answer.verdict = "effect";
  o.answer.names = {"spin-friction"};
  EXPECT_TRUE(o.wrong());
  EXPECT_FALSE(o.in_set());
  o.answer.verdict = "ambiguous";
  o.answer.names = {"spin-friction", "windage"};
  EXPECT_FALSE(o.wrong());
  EXPECT_TRUE(o.in_set());
  EXPECT_FALSE(o.exact());
  o.answer.names = {"windage", "lubricant-drag"};
  EXPECT_TRUE(o.exact());
  o.answer.verdict = "several-effects";
  EXPECT_FALSE(o.exact());
}

}  // namespace
}  // namespace hidden_effect
