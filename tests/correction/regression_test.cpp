#include "correction/regression.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "correction/metrics.h"
#include "tests/correction/reference.h"

namespace raceway::correction {
namespace {

Eigen::VectorXd column(const nlohmann::json& list) {
  const auto values = numbers(list);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(Regression, FindsTheReferenceCoefficients) {
  const auto known = reference("mlr_small");
  const Eigen::VectorXd y = column(known["displacement"]);
  Eigen::MatrixXd columns(y.size(), 3);
  columns << column(known["T_sp"]), column(known["T_base"]), Eigen::VectorXd::Ones(y.size());
  const Regression r = regress(columns, y);
  for (Eigen::Index k = 0; k < 3; ++k)
    EXPECT_NEAR(r.coefficients(k), known["beta"][static_cast<std::size_t>(k)].get<double>(), 1e-9);
  EXPECT_NEAR(r.condition, known["condition"].get<double>(), 1e-7);
}

TEST(Regression, RefusesColumnsThatDependOnEachOther) {
  Eigen::MatrixXd columns(4, 2);
  columns << 1, 2, 2, 4, 3, 6, 4, 8;
  EXPECT_THROW(static_cast<void>(regress(columns, Eigen::VectorXd::Ones(4))),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(regress(columns.topRows(1), Eigen::VectorXd::Ones(1))),
               std::invalid_argument);
}

TEST(SisterScale, IsTheReferenceGainOfAnotherSpindle) {
  const auto known = reference("gain_model");
  const Eigen::VectorXd spindle = column(known["spindle_part"]),
                        rest = column(known["ambient_part"]), measured = column(known["measured"]);
  const double g = sister_scale(measured, rest, spindle);
  EXPECT_NEAR(g, known["g"].get<double>(), 1e-9);
  const Eigen::VectorXd with = rest + g * spindle, without = rest + spindle;
  const auto fit = [&](const Eigen::VectorXd& simulated) {
    return metrics({measured.data(), 8}, {simulated.data(), 8}).fit_percent;
  };
  EXPECT_NEAR(fit(with), known["fit_with_g"].get<double>(), 1e-9);
  EXPECT_NEAR(fit(without), known["fit_without"].get<double>(), 1e-9);
}

}  // namespace
}  // namespace raceway::correction
