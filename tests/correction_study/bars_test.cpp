#include "tests/correction_study/bars.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace correction_study {
namespace {

Outcome outcome(std::string kind, std::vector<std::string> hidden, verdict::Verdict verdict,
                std::vector<std::vector<std::string>> sets) {
  Outcome o{.of = {.name = kind + "-1", .kind = kind, .hidden = hidden}};
  o.of.outside = kind == "door";
  if (!o.of.outside) o.of.accept = hidden;
  o.of.verdicts = hidden.empty()      ? std::vector<std::string>{"nothing-missing"}
                  : o.of.outside      ? std::vector<std::string>{"not-in-catalogue", "effect-like"}
                  : hidden.size() > 1 ? std::vector<std::string>{"several-effects"}
                                      : std::vector<std::string>{"effect", "ambiguous"};
  o.verdict = verdict;
  o.sets = std::move(sets);
  return o;
}

using verdict::Verdict;

TEST(Bars, ASetWithTheRightNameIsRight) {
  const auto single = [](Verdict v, std::vector<std::vector<std::string>> sets) {
    return outcome("motor-heat", {"motor-heat"}, v, std::move(sets));
  };
  EXPECT_TRUE(single(Verdict::effect, {{"motor-heat"}}).right());
  EXPECT_TRUE(single(Verdict::ambiguous, {{"slow-drift"}, {"motor-heat"}}).right());
  EXPECT_FALSE(single(Verdict::effect, {{"slow-drift"}}).right());
  EXPECT_TRUE(single(Verdict::effect, {{"slow-drift"}}).wrong());
  EXPECT_TRUE(single(Verdict::effect_like, {{"slow-drift"}}).wrong());
  EXPECT_TRUE(single(Verdict::several_effects, {{"motor-heat", "slow-drift"}}).wrong());
  EXPECT_FALSE(single(Verdict::effect_like, {{"motor-heat"}}).right());
  EXPECT_FALSE(single(Verdict::effect_like, {{"motor-heat"}}).wrong());
  EXPECT_FALSE(single(Verdict::not_in_catalogue, {}).wrong());
}

TEST(Bars, TwoEffectsAreRightTogetherAlone) {
  const std::vector<std::string> both{"motor-heat", "ambient-drift"};
  const auto pair = [&](Verdict v, std::vector<std::vector<std::string>> sets) {
    return outcome("pair", both, v, std::move(sets));
  };
  EXPECT_TRUE(pair(Verdict::several_effects, {{"ambient-drift", "motor-heat"}}).right());
  EXPECT_TRUE(pair(Verdict::several_effects, {{"ambient-drift", "slow-drift"}}).wrong());
  EXPECT_TRUE(pair(Verdict::effect, {{"motor-heat"}}).wrong());
  EXPECT_FALSE(pair(Verdict::effect_like, {{"motor-heat"}}).wrong());
  EXPECT_TRUE(pair(Verdict::effect_like, {{"slow-drift"}}).wrong());
}

TEST(Bars, OutsideTheCatalogueEveryStatementIsWrong) {
  EXPECT_TRUE(outcome("door", {"door"}, Verdict::not_in_catalogue, {}).right());
  EXPECT_TRUE(outcome("door", {"door"}, Verdict::effect_like, {{"slow-drift"}}).right());
  EXPECT_FALSE(outcome("door", {"door"}, Verdict::effect_like, {{"slow-drift"}}).wrong());
  EXPECT_TRUE(outcome("door", {"door"}, Verdict::effect, {{"slow-drift"}}).wrong());
}

TEST(Bars, CountSharesOfWhatTheyAskFor) {
  std::vector<Outcome> outcomes(4, outcome("nothing-missing", {}, Verdict::nothing_missing, {}));
  outcomes.push_back(outcome("nothing-missing", {}, Verdict::effect, {{"slow-drift"}}));
  outcomes.push_back(outcome("motor-heat", {"motor-heat"}, Verdict::effect, {{"motor-heat"}}));
  outcomes.back().failure = "not read";
  const std::vector<Bar> list = bars(outcomes);
  const auto alarm =
      std::find_if(list.begin(), list.end(), [](const Bar& b) { return b.number == "4"; });
  ASSERT_NE(alarm, list.end());
  EXPECT_EQ(alarm->cases, 5);
  EXPECT_DOUBLE_EQ(alarm->measured, 20.0);
  EXPECT_TRUE(alarm->missed());
  // Wilson's interval of 1 in 5.
  EXPECT_NEAR(alarm->lower, 3.6, 0.05);
  EXPECT_NEAR(alarm->upper, 62.4, 0.05);
  const auto right =
      std::find_if(list.begin(), list.end(), [](const Bar& b) { return b.number == "5"; });
  EXPECT_EQ(right->cases, 0);
  EXPECT_FALSE(right->missed());
}

}  // namespace
}  // namespace correction_study
