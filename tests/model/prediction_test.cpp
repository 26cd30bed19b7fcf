#include "model/prediction.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "effects/catalogue.h"
#include "model/steps.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

Model with_spin() {
  Model model = synthetic_model();
  const effects::Description* spin = effects::find("spin-friction");
  model.effects.push_back({.description = spin, .values = {0.06}});
  return model;
}

TEST(Prediction, IsTheSumOfItsMomentsAndTakesPower) {
  const bearing::OperatingPoint point{.speed = 8000 * rpm, .axial_load = 600.0};
  const FrictionPrediction p = predict_friction(with_spin(), point);
  ASSERT_TRUE(p.predicted());
  ASSERT_EQ(p.effects.size(), 1U);
  EXPECT_GT(p.load, 0.0);
  EXPECT_GT(p.viscous, 0.0);
  EXPECT_GT(p.effects[0], 0.0);
  EXPECT_NEAR(p.torque, p.load + p.viscous + p.effects[0], 1e-15);
  EXPECT_NEAR(p.power_loss, p.torque * point.speed, 1e-12);
}

TEST(Prediction, DemandsAnEquilibriumOnlyForEffectsThatUseIt) {
  EXPECT_FALSE(needs_equilibrium(synthetic_model()));
  EXPECT_TRUE(needs_equilibrium(with_spin()));
  Model skf = synthetic_model();
  skf.law = friction::FrictionLaw::skf;
  skf.law_values = {0.15, 0.05, 6e-8};
  EXPECT_FALSE(needs_equilibrium(skf));

  const bearing::OperatingPoint point{.speed = 3000 * rpm, .axial_load = 300.0};
  const FrictionPrediction bare = predict_friction(synthetic_model(), point);
  EXPECT_EQ(bare.equilibrium, nullptr);
  EXPECT_EQ(bare.report.status, bearing::SolveStatus::not_run);
  const FrictionPrediction full = predict_friction(synthetic_model(), point, true);
  ASSERT_NE(full.equilibrium, nullptr);
  EXPECT_TRUE(full.report.converged());
  EXPECT_EQ(full.torque, bare.torque);
}

TEST(Prediction, OfAnUnloadedBearingIsItsViscousMoment) {
  // A coast-down without known load has no equilibrium, and friction all the same.
  const bearing::OperatingPoint point{.speed = 500 * rpm, .axial_load = 0.0};
  const FrictionPrediction p = predict_friction(synthetic_model(), point);
  ASSERT_TRUE(p.predicted());
  EXPECT_EQ(p.load, 0.0);
  EXPECT_EQ(p.torque, p.viscous);
}

TEST(Prediction, WithoutBalanceIsNotANumberAndSaysWhy) {
  const bearing::OperatingPoint point{.speed = 500 * rpm, .axial_load = 0.0};
  const FrictionPrediction p = predict_friction(with_spin(), point);
  EXPECT_FALSE(p.predicted());
  EXPECT_TRUE(std::isnan(p.torque));
  EXPECT_EQ(p.report.status, bearing::SolveStatus::no_equilibrium);
  ASSERT_EQ(p.effects.size(), 1U);
  EXPECT_TRUE(std::isnan(p.effects[0]));

  const FrictionPrediction unknown =
      predict_friction(synthetic_model(), {.speed = 500 * rpm, .axial_load = unset});
  EXPECT_FALSE(unknown.predicted());
  EXPECT_EQ(unknown.report.status, bearing::SolveStatus::not_finite);
}

TEST(Prediction, OfALawThatNeedsNoBallsIsThereWithoutBalance) {
  const bearing::OperatingPoint point{.speed = 500 * rpm, .axial_load = 0.0};
  const FrictionPrediction p = predict_friction(synthetic_model(), point, true);
  EXPECT_TRUE(p.predicted());
  EXPECT_EQ(p.equilibrium, nullptr);
  EXPECT_EQ(p.report.status, bearing::SolveStatus::no_equilibrium);
}

TEST(Prediction, UsesTheViscosityOfTheRowsTemperature) {
  bearing::OperatingPoint point{.speed = 8000 * rpm, .axial_load = 600.0};
  const FrictionPrediction cold = predict_friction(synthetic_model(), point);
  point.temperature = kelvin(70.0);
  const FrictionPrediction warm = predict_friction(synthetic_model(), point);
  const friction::Lubricant oil = synthetic_model().lubricant;
  const double ratio =
      oil.kinematic_viscosity(kelvin(70.0)) / oil.kinematic_viscosity(kelvin(40.0));
  EXPECT_NEAR(warm.viscous / cold.viscous, std::pow(ratio, 2.0 / 3.0), 1e-12);
  EXPECT_EQ(warm.load, cold.load);
}

TEST(Prediction, OfARigCountsItsBearings) {
  Rig rig;
  rig.bearings = 3;
  EXPECT_DOUBLE_EQ(rig_torque(rig, 0.1), 0.3);
}

TEST(PredictSweep, DoesNotDependOnTheNumberOfThreads) {
  const Model model = with_spin();
  std::vector<double> speeds;  // so many that several threads have their share
  for (double speed = 500; speed < 14000; speed += 250) speeds.push_back(speed);
  const DataSet plan = factorial_plan(speeds, {0, 50, 100, 300, 600, 1000}, {25, 50});
  std::vector<bearing::OperatingPoint> points;
  for (const Row& row : plan.rows) points.push_back(row.point);
  std::vector<FrictionPrediction> alone(points.size()), shared(points.size());
  {
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    predict_sweep(model, points, alone);
  }
  {
    tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    predict_sweep(model, points, shared);
  }
  int predicted = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(alone[i].report.status, shared[i].report.status);
    EXPECT_EQ(alone[i].predicted(), points[i].axial_load > 0.0);
    if (!alone[i].predicted()) continue;
    ++predicted;
    EXPECT_EQ(alone[i].torque, shared[i].torque);
    // The warm start changes the way to the solution, not the solution.
    EXPECT_NEAR(alone[i].torque, predict_friction(model, points[i]).torque, 1e-8 * alone[i].torque);
  }
  EXPECT_EQ(predicted, 540);
  EXPECT_THROW(predict_sweep(model, points, std::span(alone).first(3)), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::fit
