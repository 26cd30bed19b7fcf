#include "fit/free_parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effects/catalogue.h"
#include "tests/fit/synthetic.h"

namespace raceway::fit {
namespace {

TEST(FreeParameters, AreThoseOfTheLawUnlessTheModelNamesThem) {
  Model model = synthetic_model();
  EXPECT_EQ(default_free(friction::FrictionLaw::palmgren), (std::vector<std::string>{"f0", "z"}));
  EXPECT_EQ(default_free(friction::FrictionLaw::skf), (std::vector<std::string>{"mu_EHL", "K_rs"}));
  std::vector<ModelParameter> free = free_parameters(model);
  ASSERT_EQ(free.size(), 2U);
  EXPECT_EQ(free[0].name, "f0");
  EXPECT_EQ(free[1].name, "z");
  model.free = {"y"};
  free = free_parameters(model);
  ASSERT_EQ(free.size(), 1U);
  EXPECT_EQ(free[0].unit, "1");
  EXPECT_EQ(free[0].get(model), 0.33);
  free[0].set(model, 0.4);
  EXPECT_EQ(model.law_values[2], 0.4);
}

TEST(FreeParameters, OfAnEffectAreNamedByItsId) {
  Model model = synthetic_model();
  model.effects.push_back({.description = effects::find("spin-friction"), .values = {0.06}});
  model.free = {"f0", "spin-friction.friction_coefficient"};
  const std::vector<ModelParameter> free = free_parameters(model);
  ASSERT_EQ(free.size(), 2U);
  EXPECT_EQ(free[1].effect, 0);
  EXPECT_EQ(free[1].get(model), 0.06);
  free[1].set(model, 0.05);
  EXPECT_EQ(model.effects[0].values[0], 0.05);
  EXPECT_LT(free[1].lower, free[1].upper);
}

TEST(FreeParameters, WithAnUnknownNameAreRefusedWithTheNearest) {
  Model model = synthetic_model();
  model.free = {"f1"};
  try {
    (void)free_parameters(model);
    FAIL() << "f1 is not a parameter";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"f1\""));
    EXPECT_THAT(error.what(), testing::HasSubstr("nearest: f0"));
  }
  model.free = {"f0", "f0"};
  EXPECT_THROW((void)free_parameters(model), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::fit
