#include "verdict/hidden_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/support/loop.h"
#include "tests/support/synthetic.h"
#include "verdict/diagnose.h"

namespace raceway::fit {
namespace {

using testing::HasSubstr;

/// Four runs over the same six speeds, each speed within 1 % of the others; 2 % noise, and a factor
/// per run.
DataSet runs_with(const std::vector<double>& factors, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  DataSet data = factorial_plan({600, 1500, 3500, 7000, 11000, 16000}, {600}, {40},
                                static_cast<int>(factors.size()));
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    Row& row = data.rows[i];
    row.run = static_cast<int>(i / 6);
    row.point.speed *= 1.0 - 0.0025 * static_cast<double>(row.run);
  }
  measure(synthetic_model(), 0.0, random, data);
  for (Row& row : data.rows)
    row.measured *= factors[static_cast<std::size_t>(row.run)] * (1.0 + 0.02 * gauss(random));
  for (std::size_t run = 0; run < factors.size(); ++run) data.runs.push_back(std::to_string(run));
  return data;
}

std::optional<verdict::HiddenInput> hidden_in(const DataSet& data) {
  return verdict::find_hidden_input(data, subject_of(synthetic_model())->measured().front());
}

TEST(HiddenInput, IsSeenInRunsThatReadDifferentlyAtEqualPoints) {
  const DataSet data = runs_with({1.0, 1.2, 1.4, 1.6});
  const auto found = hidden_in(data);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->scatter, 0.2, 0.02);  // of log 1, 1.2, 1.4, 1.6
  EXPECT_TRUE(found->follows_the_runs());
  EXPECT_EQ(data.rows[found->low].run, 0);
  EXPECT_EQ(data.rows[found->high].run, 3);
  EXPECT_NEAR(data.rows[found->low].point.speed, data.rows[found->high].point.speed,
              0.02 * data.rows[found->low].point.speed);
}

TEST(HiddenInput, IsNotWhatRigsScatter) {
  EXPECT_FALSE(hidden_in(runs_with({1.0, 1.0, 1.0, 1.0})));
  EXPECT_FALSE(hidden_in(runs_with({0.97, 1.0, 1.02, 1.05})));
}

TEST(HiddenInput, IsNotAFewWrongReadings) {
  DataSet data = runs_with({1.0, 1.0, 1.0, 1.0});
  for (const std::size_t i : {2, 9, 22}) data.rows[i].measured *= 10.0;
  EXPECT_FALSE(hidden_in(data));
}

TEST(HiddenInput, DoesNotFollowRunsWhereRowsScatterByThemselves) {
  DataSet data = runs_with({1.0, 1.0, 1.0, 1.0});
  std::mt19937 random(5);
  std::normal_distribution<double> gauss(0.0, 0.25);
  for (Row& row : data.rows) row.measured *= std::exp(gauss(random));
  const auto found = hidden_in(data);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->follows_the_runs());
}

TEST(HiddenInput, IsNotAskedWhereTimeMayBeTheReason) {
  DataSet data = runs_with({1.0, 1.2, 1.4, 1.6});
  for (Row& row : data.rows) row.time = 60.0 * row.line;
  EXPECT_FALSE(hidden_in(data));
}

TEST(HiddenInput, IsAVerdictOfItsOwnWhereItFollowsTheRuns) {
  Model model = synthetic_model();
  model.free = {"f0", "z"};
  DataSet data = runs_with({1.0, 1.2, 1.4, 1.6});
  const verdict::Diagnosis told = diagnose(model, data);
  EXPECT_EQ(told.verdict, verdict::Verdict::not_in_catalogue);
  EXPECT_THAT(told.sentence, HasSubstr("not an input of the model"));
  EXPECT_EQ(told.channels[0].rmse_after, told.channels[0].rmse_before);

  // Without run_id it may be scatter: a warning beside the verdict.
  for (Row& row : data.rows) row.run = -1;
  data.runs.clear();
  const verdict::Diagnosis warned = diagnose(model, data);
  EXPECT_EQ(warned.verdict, verdict::Verdict::nothing_missing);
  EXPECT_THAT(warned.sentence, HasSubstr("But readings at nearly equal operating points differ"));
}

}  // namespace
}  // namespace raceway::fit
