#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

// With a tolerance the question is whether what is missing matters on held-out rows.
namespace raceway::fit {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::vector<std::string> drag_alone{"lubricant-drag"};

/// Drag of this size [N mm at 10 000 rpm] hidden in readings that scatter by 1 N mm.
DataSet with_drag(double size) {
  Model truth = synthetic_model();
  truth.effects.push_back({.description = effects::find("lubricant-drag"), .values = {size}});
  DataSet data = factorial_plan({600, 1500, 3500, 7000, 11000, 16000}, {250, 600, 1400, 3000},
                                {25, 35, 45, 55, 65});
  std::mt19937 random(3);
  measure(truth, 1.0 * N_mm, random, data);
  return data;
}

Model content_with(double tolerance) {
  Model model = synthetic_model();
  model.tolerances = {{std::string(record::friction_torque.name), tolerance}};
  return model;
}

TEST(Tolerance, LeavesOutOfTheVerdictWhatIsCertainButDoesNotMatter) {
  const DataSet data = with_drag(10.0);
  ASSERT_EQ(diagnose(synthetic_model(), data).verdict, verdict::Verdict::effect);
  const verdict::Diagnosis d = diagnose(content_with(20.0 * N_mm), data);
  EXPECT_EQ(d.verdict, verdict::Verdict::nothing_missing);
  EXPECT_TRUE(d.within_tolerance);
  EXPECT_THAT(d.significant_but_immaterial, Contains("lubricant-drag"));
  EXPECT_THAT(d.sentence, HasSubstr("No important effect is missing"));
}

TEST(Tolerance, IsMetByTheEffectThatIsNamed) {
  const verdict::Diagnosis d = diagnose(content_with(2.0 * N_mm), with_drag(60.0));
  EXPECT_FALSE(d.within_tolerance);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "lubricant-drag");
  EXPECT_LE(d.channels[0].rmse_held_out_after, 2.0 * N_mm);
  EXPECT_GT(d.channels[0].rmse_held_out_before, 2.0 * N_mm);
}

// Nothing can be held against what is below the noise of the data.
TEST(Tolerance, BelowTheNoiseAsksNoMoreThanTheNoise) {
  const verdict::Diagnosis d = diagnose(content_with(0.5 * N_mm), with_drag(60.0));
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "lubricant-drag");
  EXPECT_EQ(diagnose(content_with(0.1 * N_mm), with_drag(0.0)).verdict,
            verdict::Verdict::nothing_missing);
}

TEST(Tolerance, LeavesTheLikelihoodToTellWhatItCan) {
  // Windage comes as near to a wide tolerance, and the data know better.
  const verdict::Diagnosis d = diagnose(content_with(10.0 * N_mm), with_drag(60.0));
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "lubricant-drag");
}

TEST(Tolerance, RefusesToAddWhatWasNotNeeded) {
  const DataSet data = with_drag(10.0);
  EXPECT_FALSE(add(synthetic_model(), drag_alone, data).refused);
  const verdict::AddResult result = add(content_with(20.0 * N_mm), drag_alone, data);
  EXPECT_TRUE(result.refused);
  EXPECT_THAT(
      result.reason,
      HasSubstr("without the effect, the part of the held-out error that the noise does not "
                "explain is within the tolerance"));
}

TEST(Tolerance, IsStatedByAComparison) {
  const DataSet data = with_drag(10.0);
  EXPECT_THAT(compare(content_with(50.0 * N_mm), data).statement,
              HasSubstr("within the tolerance of 50 N mm"));
  EXPECT_THAT(compare(content_with(0.1 * N_mm), data).statement,
              HasSubstr("exceeds the tolerance"));
}

}  // namespace
}  // namespace raceway::fit
