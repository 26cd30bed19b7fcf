#include "verdict/calibrate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::vector<double> speeds_of_calibration{500, 1500, 3000, 5000, 7500, 10000, 12500, 15000};

DataSet full_plan() {
  return factorial_plan(speeds_of_calibration, {100, 300, 600, 1200}, {25, 40, 60});
}

TEST(Calibrate, FindsParametersOfNoiselessDataFromAFarStart) {
  Model truth = synthetic_model();
  truth.law_values = {3.1, 0.0006, 0.41};
  std::mt19937 random(1);
  DataSet data = full_plan();
  measure(truth, 0.0, random, data);
  Model model = synthetic_model();
  model.free = {"f0", "z", "y"};
  const verdict::Calibration fit = calibrate(model, data);
  ASSERT_TRUE(fit.converged());
  ASSERT_EQ(fit.parameters.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(model_of(fit).law_values[k], truth.law_values[k], 1e-7 * truth.law_values[k]);
    EXPECT_EQ(fit.parameters[k].value, model_of(fit).law_values[k]);
    EXPECT_EQ(fit.parameters[k].start, model.law_values[k]);
    EXPECT_EQ(fit.parameters[k].at_bound, Bound::none);
    EXPECT_TRUE(fit.parameters[k].identifiable);
  }
  EXPECT_LT(fit.channels[0].rmse_after, 1e-7 * fit.channels[0].rmse_before);
}

TEST(Calibrate, WeighsRowsByTheirStandardDeviation) {
  Model truth = synthetic_model();
  std::mt19937 random(5);
  DataSet data = full_plan();
  measure(truth, 0.1 * N_mm, random, data);
  declare_noise(0.1 * N_mm, data);
  for (std::size_t i = 0; i < data.rows.size(); i += 3) {
    data.rows[i].measured *= 1.5;  // known to be bad, and declared so
    data.rows[i].std = 1000.0 * N_mm;
  }
  const verdict::Calibration fit = calibrate(truth, data);
  EXPECT_NEAR(fit.parameters[0].value, 1.5, 0.005);
  EXPECT_NEAR(fit.parameters[1].value, 0.001, 5e-6);
}

TEST(Calibrate, SaysThatZAndYCannotBeToldApartAtOneLoad) {
  Model truth = synthetic_model();
  truth.law_values = {2.0, 0.0012, 0.33};
  std::mt19937 random(6);
  DataSet data = factorial_plan(speeds_of_calibration, {600}, {25, 40, 60});
  measure(truth, 0.5 * N_mm, random, data);
  Model model = synthetic_model();
  model.free = {"f0", "z", "y"};
  const verdict::Calibration fit = calibrate(model, data);
  ASSERT_TRUE(fit.converged());
  EXPECT_TRUE(fit.parameters[0].identifiable);
  EXPECT_NEAR(fit.parameters[0].value, 2.0, 4.0 * fit.parameters[0].std);
  for (const std::size_t k : {1U, 2U}) {
    EXPECT_FALSE(fit.parameters[k].identifiable);
    EXPECT_TRUE(std::isnan(fit.parameters[k].std));
    EXPECT_TRUE(std::isnan(fit.correlation(0, static_cast<Eigen::Index>(k))));
  }
  EXPECT_TRUE(fit.parameters[2].held);
  EXPECT_EQ(fit.parameters[2].value, 0.33);
  EXPECT_NEAR(fit.parameters[1].value, 0.0012,
              2e-5);  // right, as y happens to be held at the truth
  EXPECT_THAT(texts(fit.messages), Contains(HasSubstr("these data cannot separate z and y")));
}

TEST(Calibrate, SaysThatZIsWithoutEffectWhereNoLoadIsKnown) {
  std::mt19937 random(7);
  DataSet data = factorial_plan(speeds_of_calibration, {0}, {25, 40, 60});
  measure(synthetic_model(), 0.5 * N_mm, random, data);
  const verdict::Calibration fit = calibrate(synthetic_model(), data);
  ASSERT_TRUE(fit.converged());
  EXPECT_FALSE(fit.parameters[1].identifiable);
  EXPECT_EQ(fit.parameters[1].value, 0.001);
  EXPECT_THAT(texts(fit.messages), Contains(HasSubstr("do not depend on z")));
  Model model = synthetic_model();
  model.free = {"z"};
  EXPECT_EQ(calibrate(model, data).status, FitStatus::nothing_to_fit);
}

TEST(Calibrate, SaysThatAParameterIsLooseWhereLoadsHardlyDiffer) {
  std::mt19937 random(8);
  DataSet data = factorial_plan(speeds_of_calibration, {600, 601}, {25, 40, 60});
  Model model = synthetic_model();
  // With F_b y meets its bound here before z does; with P0 z is first, and y then fixed.
  model.f1_load = friction::F1Load::F_b;
  measure(model, 5.0 * N_mm, random, data);
  model.free = {"f0", "z", "y"};
  const verdict::Calibration fit = calibrate(model, data);
  EXPECT_TRUE(fit.parameters[0].identifiable);
  EXPECT_TRUE(!fit.parameters[2].identifiable || fit.parameters[2].at_bound != Bound::none);
}

TEST(Calibrate, SaysThatAParameterIsAtItsBound) {
  Model truth = synthetic_model();
  std::mt19937 random(9);
  DataSet data = full_plan();
  measure(truth, 0.5 * N_mm, random, data);
  // Less than without any load moment: z would be negative, whatever weighs the rows.
  for (Row& row : data.rows)
    row.measured -= 2.0 * model::predict_friction(truth, row.point, false).load;
  const verdict::Calibration fit = calibrate(truth, data);
  ASSERT_TRUE(fit.converged());
  EXPECT_EQ(fit.parameters[1].at_bound, Bound::lower);
  EXPECT_EQ(fit.parameters[1].value, fit.parameters[1].lower);
  EXPECT_TRUE(std::isnan(fit.parameters[1].std));
  EXPECT_TRUE(std::isfinite(fit.parameters[0].std));
  EXPECT_THAT(texts(fit.messages), Contains(HasSubstr("z is at its lower bound")));
}

TEST(Calibrate, WidensStandardErrorsWhereTheModelMissesSomething) {
  Model truth = synthetic_model();
  std::mt19937 random(10);
  DataSet data = full_plan();
  measure(truth, 0.5 * N_mm, random, data);
  declare_noise(0.5 * N_mm, data);
  const verdict::Calibration right = calibrate(truth, data);
  for (Row& row : data.rows) row.measured += 20.0 * N_mm * std::pow(row.point.speed / 1000.0, 2);
  const verdict::Calibration wrong = calibrate(truth, data);
  EXPECT_GT(wrong.reduced_chi_square, 10.0);
  EXPECT_NEAR(right.reduced_chi_square, 1.0, 0.3);
  EXPECT_GT(wrong.parameters[0].std, 3.0 * right.parameters[0].std);
  EXPECT_THAT(texts(wrong.messages), Contains(HasSubstr("standard errors are multiplied")));
}

TEST(Calibrate, IsNotBentToTheQuietestRowsWhereTheModelMissesSomething) {
  // Weights by noise alone would follow the few quiet rows and raise the error of all others.
  const Model truth = synthetic_model();
  std::mt19937 random(16);
  DataSet data = full_plan();
  measure(truth, 0.0, random, data);
  declare_noise(1.0 * N_mm, data);
  for (Row& row : data.rows) {
    row.measured += 20.0 * N_mm * std::pow(row.point.speed / 1000.0, 2);
    if (row.point.speed > 14000 * rpm) row.std = 0.01 * N_mm;
  }
  const verdict::Calibration fit = calibrate(truth, data);
  ASSERT_TRUE(fit.converged());
  for (Row& row : data.rows) row.std = unset;
  EXPECT_NEAR(fit.channels[0].rmse_after, calibrate(truth, data).channels[0].rmse_after,
              0.05 * fit.channels[0].rmse_after);
}

TEST(Calibrate, FitsParametersOfAnEffectAndOfARigWithTwoBearings) {
  Model truth = synthetic_model();
  truth.rig.bearings = 2;
  truth.effects.push_back({.description = effects::find("spin-friction"), .values = {0.07}});
  std::mt19937 random(11);
  DataSet data = full_plan();
  measure(truth, 0.0, random, data);
  Model model = truth;
  model.law_values = {1.0, 0.002, 0.33};
  model.effects[0].values = {0.04};
  model.free = {"f0", "z", "spin-friction.friction_coefficient"};
  const verdict::Calibration fit = calibrate(model, data);
  ASSERT_TRUE(fit.converged());
  EXPECT_NEAR(model_of(fit).law_values[0], 1.5, 1e-5);
  EXPECT_NEAR(model_of(fit).law_values[1], 0.001, 1e-8);
  EXPECT_NEAR(model_of(fit).effects[0].values[0], 0.07, 1e-6);
}

TEST(Calibrate, FitsTheSkfLaw) {
  Model truth = synthetic_model();
  truth.law = friction::FrictionLaw::skf;
  truth.law_values = {0.15, 0.07, 3e-8};
  std::mt19937 random(12);
  DataSet data = full_plan();
  measure(truth, 0.0, random, data);
  Model model = truth;
  model.law_values = {0.15, 0.05, 6e-8};
  const verdict::Calibration fit = calibrate(model, data);
  ASSERT_TRUE(fit.converged());
  EXPECT_NEAR(model_of(fit).law_values[1], 0.07, 1e-7);
  EXPECT_NEAR(model_of(fit).law_values[2], 3e-8, 1e-12);
}

TEST(Calibrate, LeavesOutRowsWithoutBalanceAndListsThem) {
  Model model = synthetic_model();
  model.effects.push_back({.description = effects::find("spin-friction"), .values = {0.06}});
  std::mt19937 random(13);
  DataSet data = full_plan();
  measure(model, 0.0, random, data);
  data.rows[4].point.axial_load = 0.0;
  const verdict::Calibration fit = calibrate(model, data);
  EXPECT_TRUE(fit.converged());
  EXPECT_EQ(fit.rows, static_cast<int>(data.rows.size()) - 1);
  EXPECT_EQ(fit.rows_not_predicted, std::vector<std::size_t>{4});
}

TEST(Calibrate, RefusesFewerRowsThanParameters) {
  std::mt19937 random(14);
  DataSet data = factorial_plan({5000}, {600}, {40});
  measure(synthetic_model(), 0.0, random, data);
  EXPECT_THROW((void)calibrate(synthetic_model(), data), std::invalid_argument);
  data.quantity = Quantity::axial_displacement;
  EXPECT_THROW((void)calibrate(synthetic_model(), data), std::invalid_argument);
}

TEST(Calibrate, HasNoStandardErrorsWithoutARowToSpare) {
  std::mt19937 random(15);
  DataSet data = factorial_plan({5000, 12000}, {600}, {40});
  measure(synthetic_model(), 0.5 * N_mm, random, data);
  const verdict::Calibration fit = calibrate(synthetic_model(), data);
  ASSERT_TRUE(fit.converged());
  EXPECT_EQ(fit.degrees_of_freedom, 0);
  EXPECT_TRUE(std::isnan(fit.parameters[0].std));
}

}  // namespace
}  // namespace raceway::fit
