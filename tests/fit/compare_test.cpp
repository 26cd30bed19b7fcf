#include "verdict/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"
#include "verdict/calibrate.h"

namespace raceway::fit {
namespace {

using testing::HasSubstr;

const std::vector<double> eight_speeds{500, 1500, 3000, 5000, 7500, 10000, 12500, 15000};

TEST(Compare, CountsErrorsAsPredictionMinusReading) {
  DataSet data = factorial_plan({1000, 2000, 3000, 4000}, {300}, {40});
  const std::vector<double> readings{1.0, 2.0, 3.0, 4.0}, predicted{1.5, 2.0, 2.0, 4.0};
  for (std::size_t i = 0; i < 4; ++i) data.rows[i].measured = readings[i];
  const verdict::Comparison c = compare(predicted, data);
  EXPECT_EQ(c.rows, 4);
  EXPECT_NEAR(c.bias, -0.125, 1e-15);
  EXPECT_NEAR(c.mae, 0.375, 1e-15);
  EXPECT_NEAR(c.rmse, std::sqrt(1.25 / 4.0), 1e-15);
  EXPECT_NEAR(c.max_abs, 1.0, 1e-15);
  EXPECT_NEAR(c.fit_percent, 100.0 * (1.0 - std::sqrt(1.25 / 5.0)), 1e-12);
  ASSERT_EQ(c.worst.size(), 4U);
  EXPECT_EQ(c.worst[0].line, data.rows[2].line);
  EXPECT_EQ(c.worst[0].residual, -1.0);
  EXPECT_TRUE(std::isnan(c.worst[0].sigmas));
  EXPECT_TRUE(std::isnan(c.lack_of_fit.p_value));
  EXPECT_EQ(c.judgement, verdict::Judgement::unknown);
  EXPECT_THAT(c.statement, HasSubstr("cannot be judged"));
}

TEST(Compare, TellsStructureFromNoiseByEveryKindOfEvidence) {
  Model truth = synthetic_model();
  truth.law_values = {1.5, 0.001, 0.33};
  std::mt19937 random(32);
  DataSet data = factorial_plan(eight_speeds, {100, 300, 600}, {25, 60}, 3);
  measure(truth, 1.0 * N_mm, random, data);
  for (Row& row : data.rows) row.measured += 15.0 * N_mm * std::pow(row.point.speed / 1000.0, 2);
  const verdict::Calibration fit = calibrate(truth, data);

  const verdict::Comparison repeats = compare(model_of(fit), data, 2);
  EXPECT_EQ(repeats.judgement, verdict::Judgement::structure);
  EXPECT_LT(repeats.lack_of_fit.p_value, 1e-20);
  EXPECT_EQ(repeats.lack_of_fit.noise_degrees_of_freedom, 96);
  EXPECT_EQ(repeats.lack_of_fit.degrees_of_freedom, 46);
  EXPECT_THAT(repeats.statement, HasSubstr("is systematic, not noise"));
  EXPECT_THAT(repeats.statement, HasSubstr("F = "));

  declare_noise(1.0 * N_mm, data);
  const verdict::Comparison declared = compare(model_of(fit), data, 2);
  EXPECT_EQ(declared.judgement, verdict::Judgement::structure);
  EXPECT_LT(declared.lack_of_fit.p_value, 1e-100);
  EXPECT_THAT(declared.statement, HasSubstr("chi2/dof = "));

  DataSet bare = factorial_plan(eight_speeds, {100, 300, 600}, {25, 60});
  measure(truth, 1.0 * N_mm, random, bare);
  for (Row& row : bare.rows) row.measured += 15.0 * N_mm * std::pow(row.point.speed / 1000.0, 2);
  const verdict::Comparison unknown = compare(model_of(calibrate(truth, bare)), bare, 2);
  EXPECT_EQ(unknown.noise.source, NoiseSource::none);
  EXPECT_EQ(unknown.judgement, verdict::Judgement::structure);
  EXPECT_LT(unknown.pattern.p_value, 1e-3);
  EXPECT_THAT(unknown.statement, HasSubstr("neighbours in speed have similar residuals"));
}

TEST(Compare, SaysWhereItFailsWorstFirst) {
  const Model truth = synthetic_model();
  std::mt19937 random(33);
  DataSet data = factorial_plan(eight_speeds, {100, 300, 600}, {25, 60});
  data.runs = {"monday", "friday"};
  for (std::size_t i = 0; i < data.rows.size(); ++i) data.rows[i].run = i % 2 == 0 ? 0 : 1;
  measure(truth, 0.1 * N_mm, random, data);
  for (Row& row : data.rows)
    if (row.point.speed > 13000 * rpm) row.measured += 10.0 * N_mm;
  const verdict::Comparison c = compare(truth, data);
  ASSERT_FALSE(c.where.empty());
  EXPECT_TRUE(*c.where[0].channel == record::speed);
  EXPECT_NEAR(c.where[0].from, 15000 * rpm, 1e-9);
  EXPECT_NEAR(c.where[0].to, 15000 * rpm, 1e-9);
  EXPECT_EQ(c.where[0].rows, 6);
  EXPECT_NEAR(c.where[0].bias, -10.0 * N_mm, 0.3 * N_mm);
  EXPECT_TRUE(std::is_sorted(c.where.begin(), c.where.end(),
                             [](const auto& a, const auto& b) { return a.rmse > b.rmse; }));
  int by_speed = 0, by_load = 0, by_temperature = 0, by_run = 0;
  for (const verdict::ErrorRange& range : c.where) {
    if (*range.channel == record::speed) ++by_speed;
    if (*range.channel == record::axial_load) ++by_load;
    if (*range.channel == record::temperature) ++by_temperature;
    if (*range.channel == record::run) ++by_run;
    EXPECT_FALSE(*range.channel == record::radial_load) << "it does not vary";
    EXPECT_EQ(!range.run.empty(), *range.channel == record::run);
  }
  EXPECT_EQ(by_speed, 8);
  EXPECT_EQ(by_load, 3);
  EXPECT_EQ(by_temperature, 2);
  EXPECT_EQ(by_run, 2);
}

TEST(Compare, BinsACoastDownIntoAboutEqualParts) {
  DataSet data;
  for (int i = 0; i < 83; ++i) {
    Row row;
    row.point.speed = (1000.0 - 11.5 * i) * rpm;
    row.point.axial_load = 100.0;
    row.measured = 1.0;
    row.line = i + 2;
    data.rows.push_back(row);
  }
  const verdict::Comparison c = compare(std::vector<double>(83, 1.1), data);
  ASSERT_EQ(c.where.size(), 8U);
  int rows = 0;
  for (const verdict::ErrorRange& range : c.where) {
    EXPECT_TRUE(*range.channel == record::speed);
    EXPECT_GE(range.rows, 10);
    EXPECT_LE(range.rows, 11);
    EXPECT_NEAR(range.bias, 0.1, 1e-12);
    rows += range.rows;
  }
  EXPECT_EQ(rows, 83);
  EXPECT_TRUE(std::isnan(c.fit_percent));  // all readings are equal
}

TEST(Compare, CountsRowsWithoutPrediction) {
  Model model = synthetic_model();
  std::mt19937 random(34);
  DataSet data = factorial_plan(eight_speeds, {100, 300}, {40});
  measure(model, 1.0 * N_mm, random, data);
  model.effects.push_back({.description = effects::find("spin-friction"), .values = {0.06}});
  data.rows[3].point.axial_load = 0.0;
  const verdict::Comparison c = compare(model, data);
  EXPECT_EQ(c.rows, 15);
  EXPECT_EQ(c.rows_not_predicted, std::vector<std::size_t>{3});
  for (Row& row : data.rows) row.point.axial_load = 0.0;
  EXPECT_THROW((void)compare(model, data), std::invalid_argument);
}

TEST(Compare, ComparesTheTorqueOfTheWholeRig) {
  Model model = synthetic_model();
  std::mt19937 random(35);
  DataSet data = factorial_plan(eight_speeds, {300}, {40});
  model.rig.bearings = 4;
  measure(model, 0.0, random, data);
  EXPECT_NEAR(compare(model, data).rmse, 0.0, 1e-15);
  model.rig.bearings = 1;
  EXPECT_GT(compare(model, data).rmse, 10.0 * N_mm);
}

}  // namespace
}  // namespace raceway::fit
