#include "model/ignored_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::model {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> keys{
    "ball_count",        "ball_diameter_mm", "contact_angle_deg", "static_load_rating_N",
    "pitch_diameter_mm", "ball_material",    "bore_mm",           "race_control"};

TEST(IgnoredData, AreThoseThatNeitherLawNorEffectTakesIn) {
  Model model = fit::synthetic_model();
  model.effects.clear();
  EXPECT_THAT(
      ignored_by_friction(model, keys),
      ElementsAre("ball_count", "ball_diameter_mm", "ball_material", "bore_mm", "race_control"));
  EXPECT_THAT(taken_in(friction::FrictionLaw::skf, keys), ElementsAre("ball_material", "bore_mm"));
  model.effects.push_back({effects::find("inlet-shear-heating"), {1.0}, nullptr});
  EXPECT_THAT(ignored_by_friction(model, keys),
              ElementsAre("ball_count", "ball_diameter_mm", "ball_material", "race_control"));
}

TEST(IgnoredData, OfAFormulaAreThoseItDoesNotName) {
  Model model = fit::synthetic_model();
  model.effects = {effects::make_effect({.id = "mine",
                                         .title = "",
                                         .torque_Nmm = "c * ball_diameter_mm * ball_count",
                                         .parameters = {{.name = "c", .unit = "1", .value = 1}}})};
  EXPECT_THAT(ignored_by_friction(model, keys),
              ElementsAre("ball_material", "bore_mm", "race_control"));
}

TEST(IgnoredData, AreNoneWhereAnEffectLooksAtTheBalls) {
  Model model = fit::synthetic_model();
  model.effects = {{effects::find("spin-friction"), {0.06}, nullptr}};
  EXPECT_THAT(ignored_by_friction(model, keys), IsEmpty());
}

}  // namespace
}  // namespace raceway::model
