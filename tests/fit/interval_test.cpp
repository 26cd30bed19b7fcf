#include "fit/interval.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::fit {
namespace {

constexpr int rows = 40;

Eigen::VectorXd positions() { return Eigen::VectorXd::LinSpaced(rows, 0.0, 2.0); }

/// y = a + b t, or y = a exp(b t), with unit noise that is no noise but a fixed pattern.
Response curve(bool exponential) {
  Response r;
  for (const char* name : {"a", "b"})
    r.parameters.push_back(
        {.name = name, .unit = "1", .start = 1.0, .lower = -50.0, .upper = 50.0, .scale = 1.0});
  r.readings = [exponential](const Eigen::VectorXd& x) {
    const Eigen::ArrayXd t = positions().array();
    if (exponential) return Eigen::VectorXd((x[0] * (x[1] * t).exp()).matrix());
    return Eigen::VectorXd((x[0] + x[1] * t).matrix());
  };
  r.find_affine_form();
  return r;
}

Eigen::VectorXd measured(const Response& response, double a, double b) {
  Eigen::VectorXd y = response.readings(Eigen::Vector2d(a, b));
  for (int i = 0; i < rows; ++i) y[i] += (i % 2 == 0 ? 1.0 : -1.0) * (0.5 + 0.02 * i);
  return y;
}

struct Fitted {
  Response response;
  Whitening whitening;
  Eigen::VectorXd y{};
  ResponseFit fit{};
};

Fitted fitted(bool exponential, double a, double b) {
  Fitted f{.response = curve(exponential),
           .whitening = Whitening(Eigen::VectorXd::Ones(rows), {}, 0.0, 0.0)};
  f.y = measured(f.response, a, b);
  f.fit = fit_response(f.response, f.whitening, f.y,
                       {Eigen::Vector2d(a, b), Eigen::Vector2d(0.9 * a, 0.9 * b)});
  return f;
}

TEST(ProfileInterval, IsThatOfTheNormalDistributionForALine) {
  const Fitted f = fitted(false, 3.0, 2.0);
  ASSERT_TRUE(f.response.affine && f.fit.converged);
  const Interval i = profile_interval(f.response, f.fit, f.whitening, f.y, 1);
  EXPECT_NEAR(i.upper - f.fit.values[1], 1.959964 * f.fit.standard_errors[1], 1e-3);
  EXPECT_NEAR(f.fit.values[1] - i.lower, 1.959964 * f.fit.standard_errors[1], 1e-3);
}

TEST(ProfileInterval, IsLopsidedWhereTheModelBends) {
  const Fitted f = fitted(true, 1.0, 0.8);
  ASSERT_TRUE(!f.response.affine && f.fit.converged);
  const Interval i = profile_interval(f.response, f.fit, f.whitening, f.y, 1);
  // Held against a scan: -2 ln L at the ends is 3.84 above its least.
  for (const double end : {i.lower, i.upper}) {
    double least = INFINITY;
    for (double a = 0.2; a < 3.0; a += 1e-4)
      least = std::min(least, (f.y - f.response.readings(Eigen::Vector2d(a, end))).squaredNorm());
    EXPECT_NEAR(least - f.fit.misfit, 3.841, 0.02);
  }
  EXPECT_GT(std::abs((i.upper - f.fit.values[1]) / (f.fit.values[1] - i.lower) - 1.0), 0.02);
}

TEST(ProfileInterval, EndsAtABound) {
  Fitted f = fitted(false, 3.0, 2.0);
  f.response.parameters[1].upper = f.fit.values[1] + 0.01;
  const Interval i = profile_interval(f.response, f.fit, f.whitening, f.y, 1);
  EXPECT_DOUBLE_EQ(i.upper, f.response.parameters[1].upper);
  EXPECT_LT(i.lower, f.fit.values[1] - 0.1);
}

}  // namespace
}  // namespace raceway::fit
