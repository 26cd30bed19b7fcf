#include "fit/likelihood.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

const std::vector<double> likelihood_speeds{500, 1500, 3000, 5000, 7500, 10000, 12500, 15000};
const double two_pi = 2.0 * pi;

/// A record that lacks nothing, or a drag of 40 N mm at 10 000 rpm.
DataSet measured_plan(double noise, bool with_drag = false) {
  Model truth = synthetic_model();
  if (with_drag) {
    effects::Effect effect;
    effect.description = effects::find("lubricant-drag");
    effect.values = {40.0};
    truth.effects.push_back(effect);
  }
  std::mt19937 random(5);
  DataSet data = factorial_plan(likelihood_speeds, {100, 300, 600, 1200}, {25, 40, 60});
  measure(truth, noise, random, data);
  return data;
}

/// Six rows, too few to tell their noise.
DataSet few_rows() {
  DataSet data = factorial_plan({1000, 6000, 12000}, {300, 900}, {40});
  std::mt19937 random(3);
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  return data;
}

std::vector<double> errors_of(const verdict::Calibration& fit, const DataSet& data) {
  std::vector<double> errors;
  const std::vector<FrictionPrediction> predictions = predict_rows(model_of(fit), data);
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    errors.push_back(data.rows[i].measured - predictions[i].reading);
  return errors;
}

TEST(Likelihood, IsThatOfTheNormalDistributionWithTheWholeCovariance) {
  // Written out by the formula of Whitening: two runs, correlation along time, unequal steps.
  constexpr int n = 6;
  const Eigen::VectorXd std = Eigen::VectorXd::LinSpaced(n, 0.5, 1.5);
  const RowOrder order{.step = {INFINITY, 1.0, 2.0, INFINITY, 1.0, 0.5},
                       .new_run = {true, false, false, true, false, false},
                       .new_state = {},
                       .new_block = {}};
  const double phi = 0.7, share = 0.3, time[] = {0.0, 1.0, 3.0, 0.0, 1.0, 1.5};
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      if (i / 3 == k / 3)
        covariance(i, k) =
            std[i] * std[k] * ((1.0 - share) * std::pow(phi, std::abs(time[i] - time[k])) + share);
  const Eigen::VectorXd errors = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
  const Whitening whitening(std, order, phi, share);
  const Likelihood l = likelihood_of(whitening(errors).squaredNorm(), whitening, 2);
  const double chi_square = errors.dot(covariance.ldlt().solve(errors));
  const double log_determinant = std::log((two_pi * covariance).determinant());
  EXPECT_NEAR(l.chi_square, chi_square, 1e-9 * chi_square);
  EXPECT_NEAR(l.log_determinant, log_determinant, 1e-9);
  EXPECT_NEAR(l.aic(), chi_square + log_determinant + 2.0 * 2.0, 1e-8);
  EXPECT_NEAR(l.bic(), chi_square + log_determinant + 2.0 * std::log(6.0), 1e-8);
  EXPECT_EQ(l.degrees_of_freedom(), 4);
}

TEST(Likelihood, OfDeclaredDeviationsIsASumOverTheRows) {
  DataSet data = few_rows();
  declare_noise(4.0 * N_mm, data);
  const verdict::Calibration fit = calibrate(synthetic_model(), data);
  ASSERT_TRUE(fit.converged());
  double chi_square = 0.0;
  for (const double e : errors_of(fit, data)) chi_square += std::pow(e / (4.0 * N_mm), 2);
  EXPECT_NEAR(fit.likelihood.chi_square, chi_square, 1e-9 * chi_square);
  EXPECT_NEAR(fit.likelihood.log_determinant, 6.0 * std::log(two_pi * std::pow(4.0 * N_mm, 2)),
              1e-9);
  EXPECT_EQ(fit.likelihood.readings, 6);
  EXPECT_EQ(fit.likelihood.parameters, 2);
  EXPECT_EQ(fit.channels[0].readings, 6);
}

TEST(Likelihood, OfScatterThatWasAddedForTheMisfitIsNotTold) {
  DataSet data = few_rows();
  declare_noise(0.1 * N_mm, data);  // twenty times too little
  const verdict::Calibration fit = calibrate(synthetic_model(), data);
  ASSERT_TRUE(fit.converged());
  EXPECT_TRUE(std::isnan(fit.likelihood.deviance));
  EXPECT_TRUE(std::isfinite(fit.likelihood.chi_square));
}

TEST(Likelihood, OfUnknownNoiseHasTheSizeThatMakesItLargest) {
  const DataSet data = few_rows();
  const verdict::Calibration fit = calibrate(synthetic_model(), data);
  ASSERT_TRUE(fit.converged());
  const std::vector<double> errors = errors_of(fit, data);
  const auto deviance = [&](double size) {
    double sum = 0.0;
    for (const double e : errors) sum += std::pow(e / size, 2) + std::log(two_pi * size * size);
    return sum;
  };
  EXPECT_TRUE(std::isnan(fit.likelihood.chi_square));
  EXPECT_NEAR(fit.likelihood.deviance, deviance(fit.channels[0].rmse_after), 1e-9);
  for (const double factor : {0.99, 1.01})
    EXPECT_LT(fit.likelihood.deviance, deviance(factor * fit.channels[0].rmse_after));
}

TEST(Likelihood, CalibrateAddAndDiagnoseHaveOne) {
  const DataSet data = measured_plan(5.0 * N_mm, true);
  const std::vector<std::string> ids{"lubricant-drag"};
  const verdict::Calibration before = calibrate(synthetic_model(), data);
  const verdict::AddResult added = add(synthetic_model(), ids, data);
  const verdict::Diagnosis diagnosis = diagnose(synthetic_model(), data);
  ASSERT_EQ(diagnosis.effects.at(0).id, "lubricant-drag");
  const Likelihood& with = added.calibration.likelihood;
  for (const Likelihood* same : {&added.before, &diagnosis.likelihood}) {
    EXPECT_NEAR(same->chi_square, before.likelihood.chi_square, 1e-6);
    EXPECT_NEAR(same->log_determinant, before.likelihood.log_determinant, 1e-6);
    EXPECT_EQ(same->parameters, 2);
  }
  EXPECT_NEAR(before.reduced_chi_square * before.degrees_of_freedom, before.likelihood.chi_square,
              1e-9 * before.likelihood.chi_square);
  // One parameter, which is the size: its gain is the fall of -2 ln L.
  EXPECT_NEAR(added.gain, added.before.deviance - with.deviance, 1e-6);
  EXPECT_NEAR(diagnosis.effects[0].likelihood.deviance, with.deviance, 1e-6);
  EXPECT_NEAR(diagnosis.fits.at(0).likelihood.deviance, with.deviance, 1e-6);
  EXPECT_NEAR(diagnosis.fits.at(0).gain, added.gain, 1e-6);
  // What add says of the estimates, diagnose says too.
  ASSERT_EQ(diagnosis.correlation.names.size(), 3U);
  EXPECT_LT((diagnosis.correlation.matrix - added.calibration.correlation).cwiseAbs().maxCoeff(),
            1e-6);
}

TEST(Likelihood, AModelThatLacksNothingKeepsItsParametersInADiagnosis) {
  const DataSet data = measured_plan(5.0 * N_mm);
  const verdict::Calibration fit = calibrate(synthetic_model(), data);
  const verdict::Diagnosis diagnosis = diagnose(synthetic_model(), data);
  ASSERT_EQ(diagnosis.verdict, verdict::Verdict::nothing_missing) << diagnosis.sentence;
  ASSERT_EQ(diagnosis.base.size(), fit.parameters.size());
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    EXPECT_NEAR(diagnosis.base[k].value, fit.parameters[k].value, 1e-6 * fit.parameters[k].value);
    EXPECT_NEAR(diagnosis.base[k].std, fit.parameters[k].std, 1e-4 * fit.parameters[k].std);
  }
}

TEST(Likelihood, ProfilesOfACalibrationAreAsWideAsItsErrors) {
  // Palmgren's law is linear in f0 and z; a model that lacks a drag has widened errors.
  for (const bool lacking : {false, true}) {
    const DataSet data = measured_plan(5.0 * N_mm, lacking);
    const verdict::Calibration fit = calibrate(synthetic_model(), data, {.profile = true});
    ASSERT_EQ(fit.profile.size(), 2U);
    EXPECT_EQ(fit.error_factor > 1.0, lacking);
    for (std::size_t k = 0; k < 2; ++k) {
      const double half = 1.959964 * fit.parameters[k].std;
      EXPECT_NEAR(fit.profile[k].upper - fit.parameters[k].value, half, 1e-4 * half);
      EXPECT_NEAR(fit.parameters[k].value - fit.profile[k].lower, half, 1e-4 * half);
    }
    EXPECT_TRUE(calibrate(synthetic_model(), data).profile.empty());
  }
}

}  // namespace
}  // namespace raceway::fit
