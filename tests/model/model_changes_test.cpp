#include "model/model_changes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

TEST(ModelChanges, AreNoneBetweenAModelAndItself) {
  const ModelChanges c = model_changes(synthetic_model(), synthetic_model());
  EXPECT_TRUE(c.added.empty() && c.removed.empty() && c.numbers.empty());
}

TEST(ModelChanges, NameWhatACalibrationAndAnAddedEffectHaveChanged) {
  const Model before = synthetic_model();
  Model after = before;
  after.law_values[0] = 1.4;
  after.effects.push_back({.description = effects::find("lubricant-drag"), .values = {60.0}});
  const ModelChanges c = model_changes(before, after);
  EXPECT_EQ(c.added, std::vector<std::string>{"lubricant-drag"});
  EXPECT_TRUE(c.removed.empty());
  ASSERT_EQ(c.numbers.size(), 2U);
  EXPECT_EQ(c.numbers[0].name, "f0");
  EXPECT_EQ(c.numbers[0].before, 1.5);
  EXPECT_EQ(c.numbers[0].after, 1.4);
  EXPECT_EQ(c.numbers[1].name, "lubricant-drag.torque_at_10000_rpm_Nmm");
  EXPECT_EQ(c.numbers[1].unit, "N mm");
  EXPECT_TRUE(std::isnan(c.numbers[1].before));
  EXPECT_EQ(c.numbers[1].after, 60.0);
}

TEST(ModelChanges, NameAnEffectThatWasTakenOutAgain) {
  Model before = synthetic_model();
  before.effects.push_back({.description = effects::find("windage"), .values = {60.0}});
  const ModelChanges c = model_changes(before, synthetic_model());
  EXPECT_EQ(c.removed, std::vector<std::string>{"windage"});
  EXPECT_TRUE(c.added.empty() && c.numbers.empty());
}

}  // namespace
}  // namespace raceway::fit
