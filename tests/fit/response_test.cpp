#include "fit/response.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

constexpr int response_rows = 60;

Parameter parameter(const char* name, double start, double lower, double upper, double scale) {
  return {
      .name = name, .unit = "1", .start = start, .lower = lower, .upper = upper, .scale = scale};
}

/// y = a + b exp(-t / τ) at t = 0, 1, 2 ...
Response decay(const Parameter& amplitude, const Parameter& time) {
  Response response;
  response.parameters = {parameter("a", 1.0, -10.0, 10.0, 1.0), amplitude, time};
  response.readings = [](const Eigen::VectorXd& x) {
    const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(response_rows, 0.0, response_rows - 1.0);
    return Eigen::VectorXd((x[0] + x[1] * (-t / x[2]).exp()).matrix());
  };
  return response;
}

Whitening unit_noise() { return {Eigen::VectorXd::Constant(response_rows, 0.01), {}, 0.0, 0.0}; }

/// y = (x² - 1)² + 0.3 (1 - x) in all rows, measured 0: a hollow near -1, met exactly near +1.
TEST(FitResponse, TriesOtherStartsUntilTheBestIsReachedTwice) {
  Response response;
  response.parameters = {parameter("x", -1.2, -3.0, 3.0, 1.0)};
  response.readings = [](const Eigen::VectorXd& x) {
    const double y = std::pow(x[0] * x[0] - 1.0, 2) + 0.3 * (1.0 - x[0]);
    return Eigen::VectorXd(Eigen::VectorXd::Constant(response_rows, y));
  };
  const auto at = [](double x) { return Eigen::VectorXd(Eigen::VectorXd::Constant(1, x)); };
  const Eigen::VectorXd measured = Eigen::VectorXd::Zero(response_rows);
  const ResponseFit fit =
      fit_response(response, unit_noise(), measured, {at(-1.2), at(1.2), at(1.4)});
  ASSERT_TRUE(fit.converged);
  EXPECT_GT(fit.values[0], 0.9);
  EXPECT_LT(fit.misfit, 1e-3);
}

TEST(CoarseFit, ComesAsNearAsItSaysWithoutTheLastSteps) {
  const Response response =
      decay(parameter("b", 1.0, -10.0, 10.0, 1.0), parameter("t", 4.0, 0.5, 100.0, 10.0));
  Eigen::VectorXd measured = response.readings(Eigen::Vector3d(2.0, 3.0, 12.0));
  for (Eigen::Index i = 0; i < measured.size(); ++i) measured[i] += i % 2 == 0 ? 0.01 : -0.01;
  const Eigen::VectorXd start = response.start();
  const ResponseFit whole = fit_response(response, unit_noise(), measured, {start, 1.25 * start});
  const ResponseFit coarse = coarse_fit(response, unit_noise(), measured, start);
  ASSERT_TRUE(whole.converged && coarse.converged);
  EXPECT_GE(coarse.misfit, whole.misfit - 1e-6);
  EXPECT_LT(coarse.misfit, whole.misfit + 0.1);
  EXPECT_LT(coarse.iterations, whole.iterations);
  EXPECT_TRUE(coarse.standard_errors.isApprox(whole.standard_errors, 0.05));
}

/// Beyond x = 1 there is no balance: a search that runs into it has found no minimum.
TEST(FitResponse, AWallWithoutBalanceIsNoMinimum) {
  Response response;
  response.parameters = {parameter("x", 0.5, 0.0, 5.0, 1.0)};
  response.readings = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(
        Eigen::VectorXd::Constant(response_rows, x[0] > 1.0 ? NAN : x[0] * x[0]));
  };
  const auto at = [](double x) { return Eigen::VectorXd(Eigen::VectorXd::Constant(1, x)); };
  const ResponseFit fit = fit_response(
      response, unit_noise(), Eigen::VectorXd::Constant(response_rows, 9.0), {at(0.5), at(0.7)});
  EXPECT_FALSE(fit.converged);
}

TEST(FitResponse, ReachesTheMinimumAtABound) {
  const Response response =
      decay(parameter("b", 1.0, -10.0, 10.0, 1.0), parameter("tau", 30.0, 20.0, 60.0, 10.0));
  const Eigen::VectorXd measured = response.readings(Eigen::Vector3d(1.0, 2.0, 8.0));
  const ResponseFit fit =
      fit_response(response, unit_noise(), measured,
                   {Eigen::Vector3d(1.0, 1.0, 30.0), Eigen::Vector3d(0.5, 3.0, 50.0)});
  ASSERT_TRUE(fit.converged);
  EXPECT_EQ(fit.at_bound, (std::vector{false, false, true}));
  // With τ held there the rest is a straight line.
  Eigen::MatrixXd columns(response_rows, 2);
  columns << Eigen::VectorXd::Ones(response_rows),
      response.readings(Eigen::Vector3d(0.0, 1.0, 20.0));
  const Eigen::VectorXd line = columns.colPivHouseholderQr().solve(measured);
  const double least = (measured - columns * line).squaredNorm() / (0.01 * 0.01);
  EXPECT_NEAR(fit.misfit, least, 1e-9 * least);
}

// An amplitude that may not be negative ends at zero where its time is far off, and nothing then
// says that another time would do better.
TEST(FitResponse, AsksForOtherShapesWhereAnAmplitudeIsZero) {
  const Response response =
      decay(parameter("b", 0.5, 0.0, 10.0, 0.5), parameter("tau", 30.0, 0.1, 100.0, 10.0));
  Eigen::VectorXd measured = response.readings(Eigen::Vector3d(1.0, 0.3, 0.5));
  measured += Eigen::VectorXd::LinSpaced(response_rows, 0.0, 0.2);
  const ResponseFit fit =
      fit_response(response, unit_noise(), measured,
                   {Eigen::Vector3d(1.0, 0.5, 30.0), Eigen::Vector3d(1.0, 0.2, 25.0)});
  ASSERT_TRUE(fit.converged);
  EXPECT_NEAR(fit.values[1], 0.2, 0.1);
  EXPECT_LT(fit.values[2], 2.0);
}

// All trial points beyond both bounds would lie on one chord.
TEST(Response, IsNotTakenForAffineWhereItsRangeIsNarrow) {
  Response response;
  response.parameters = {parameter("x", 0.52, 0.5, 0.7, 0.52)};
  response.readings = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::VectorXd::Constant(response_rows, std::pow(x[0] - 0.5, 2)));
  };
  response.find_affine_form();
  EXPECT_FALSE(response.affine);
  response.readings = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::VectorXd::Constant(response_rows, 3.0 * x[0] + 1.0));
  };
  response.find_affine_form();
  EXPECT_TRUE(response.affine);
}

TEST(ModelResponse, IsThatOfANewOneWhateverWasAskedBefore) {
  Model model = synthetic_model();
  for (const char* id : {"thermal-preload", "inlet-shear-heating", "spin-friction", "seal-friction",
                         "torque-offset"}) {
    effects::Effect effect;
    effect.description = effects::find(id);
    ASSERT_TRUE(effect.description) << id;
    effect.values = effects::initial_values(*effect.description);
    model.effects.push_back(effect);
  }
  DataSet data = factorial_plan({1000.0, 8000.0, 16000.0}, {300.0, 1500.0}, {25.0, 60.0});
  for (Row& row : data.rows) row.measured = 1.0;
  std::vector<std::string> names{"f0", "z"};
  for (const effects::Effect& e : model.effects)
    for (const effects::Parameter& p : e.description->parameters)
      names.push_back(std::string(e.description->id) + "." + std::string(p.name));
  const auto subject = subject_of(model);
  const auto record = std::make_shared<const Record>(data);
  const Observations all = observe(subject->measured(), *record, predict(*subject, *record));
  const auto response = [&] {
    return response_of(*subject, record, all, names, subject->prepare(*record));
  };
  const Response walked = response();
  Eigen::VectorXd x = walked.start();
  (void)walked.readings(x);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    x[k] += 0.01 * walked.parameters[static_cast<std::size_t>(k)].scale;
    const Eigen::VectorXd fresh = response().readings(x);
    const Eigen::VectorXd again = walked.readings(x);
    EXPECT_LE((again - fresh).cwiseAbs().maxCoeff(), 1e-12 * fresh.cwiseAbs().maxCoeff())
        << names[static_cast<std::size_t>(k)];
  }
}

}  // namespace
}  // namespace raceway::fit
