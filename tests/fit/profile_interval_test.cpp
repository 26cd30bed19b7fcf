#include "fit/profile_interval.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::fit {
namespace {

constexpr int profile_rows = 40;

Eigen::VectorXd positions() { return Eigen::VectorXd::LinSpaced(profile_rows, 0.0, 2.0); }

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
  for (int i = 0; i < profile_rows; ++i) y[i] += (i % 2 == 0 ? 1.0 : -1.0) * (0.5 + 0.02 * i);
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
           .whitening = Whitening(Eigen::VectorXd::Ones(profile_rows), {}, 0.0, 0.0)};
  f.y = measured(f.response, a, b);
  f.fit = fit_response(f.response, f.whitening, f.y,
                       {Eigen::Vector2d(a, b), Eigen::Vector2d(0.9 * a, 0.9 * b)});
  return f;
}

ProfileInterval interval_of(const Fitted& f, std::size_t parameter, double factor = 1.0) {
  return profile_interval(f.response, f.fit, f.whitening, f.y, parameter, factor);
}

/// -2 ln L but for a constant at this b, a found on a grid that is made finer around its best.
double least_at(const Fitted& f, double b) {
  const auto misfit = [&](double a) {
    return (f.y - f.response.readings(Eigen::Vector2d(a, b))).squaredNorm();
  };
  double best = 1.0;
  for (double step = 0.1; step > 1e-7; step *= 0.1) {
    const double centre = best;
    for (int k = -20; k <= 20; ++k)
      if (misfit(centre + k * step) < misfit(best)) best = centre + k * step;
  }
  return misfit(best);
}

TEST(ProfileInterval, IsThatOfTheNormalDistributionForALine) {
  const Fitted f = fitted(false, 3.0, 2.0);
  ASSERT_TRUE(f.response.affine && f.fit.converged);
  // Of a line in closed form: the variance of b is 1/sum (t - mean t)^2, that of a the mean of t^2
  // times it.
  const Eigen::ArrayXd t = positions().array();
  const double spread = (t - t.mean()).square().sum();
  const double std[] = {std::sqrt(t.square().mean() / spread), std::sqrt(1.0 / spread)};
  for (const std::size_t k : {0u, 1u})
    for (const double factor : {1.0, 2.5}) {
      const ProfileInterval i = interval_of(f, k, factor);
      const double value = f.fit.values[static_cast<Eigen::Index>(k)];
      const double half = 1.959964 * factor * std[k];
      EXPECT_NEAR(i.upper - value, half, 1e-6 * half);
      EXPECT_NEAR(value - i.lower, half, 1e-6 * half);
      EXPECT_FALSE(i.open_lower || i.open_upper);
      EXPECT_EQ(i.refits, 2);
    }
}

TEST(ProfileInterval, IsLopsidedWhereTheModelBends) {
  const Fitted f = fitted(true, 1.0, 0.8);
  ASSERT_TRUE(!f.response.affine && f.fit.converged);
  for (const double factor : {1.0, 2.0}) {
    const ProfileInterval i = interval_of(f, 1, factor);
    const double rise = 3.841459 * factor * factor;
    for (const double end : {i.lower, i.upper})
      EXPECT_NEAR(least_at(f, end) - f.fit.misfit, rise, 1e-3 * rise);
    const double above = i.upper - f.fit.values[1], below = f.fit.values[1] - i.lower;
    EXPECT_GT(std::abs(above / below - 1.0), 0.02);
    EXPECT_LE(i.refits, 16);
  }
}

TEST(ProfileInterval, IsOpenAtABoundThatItReaches) {
  Fitted f = fitted(false, 3.0, 2.0);
  f.response.parameters[1].upper = f.fit.values[1] + 0.01;
  const ProfileInterval i = interval_of(f, 1);
  EXPECT_DOUBLE_EQ(i.upper, f.response.parameters[1].upper);
  EXPECT_TRUE(i.open_upper);
  EXPECT_FALSE(i.open_lower);
  EXPECT_LT(i.lower, f.fit.values[1] - 0.1);
}

TEST(ProfileInterval, HasOneEndOfItsOwnWhereTheFitIsAtABound) {
  Fitted f = fitted(false, 3.0, 2.0);
  const double free = f.fit.values[1];
  f.response.parameters[1].lower = free + 0.05;
  f.fit = fit_response(f.response, f.whitening, f.y, {Eigen::Vector2d(3.0, 2.5)});
  ASSERT_TRUE(f.fit.at_bound[1]);
  const ProfileInterval i = interval_of(f, 1);
  EXPECT_DOUBLE_EQ(i.lower, free + 0.05);
  EXPECT_TRUE(i.open_lower);
  EXPECT_FALSE(i.open_upper);
  EXPECT_NEAR(least_at(f, i.upper) - least_at(f, i.lower), 3.841459, 1e-3);
}

TEST(ProfileInterval, EndsBeforeAPlaceThatCannotBePredicted) {
  Fitted f = fitted(true, 1.0, 0.8);
  const double end = interval_of(f, 1).lower;
  int beyond = 0;
  const auto readings = f.response.readings;
  f.response.readings = [&, readings](const Eigen::VectorXd& x) {
    Eigen::VectorXd y = readings(x);
    if (x[1] < end - 1e-3) {
      y.setConstant(NAN);
      ++beyond;
    }
    return y;
  };
  const ProfileInterval i = interval_of(f, 1);
  EXPECT_GT(beyond, 0);
  EXPECT_NEAR(i.lower, end, 1e-3 * (f.fit.values[1] - end));
  EXPECT_FALSE(i.open_lower);
}

TEST(ProfileInterval, IsOpenOnBothSidesWhereNothingDependsOnTheParameter) {
  for (const double bound : {50.0, HUGE_VAL}) {
    Fitted f = fitted(false, 3.0, 2.0);
    f.response.readings = [](const Eigen::VectorXd& x) {
      return Eigen::VectorXd(x[0] * positions());
    };
    f.response.parameters[1].lower = -bound;
    f.response.parameters[1].upper = bound;
    f.response.affine.reset();
    f.response.find_affine_form();
    f.fit = fit_response(f.response, f.whitening, f.y, {Eigen::Vector2d(1.0, 1.0)});
    ASSERT_TRUE(f.response.affine && f.fit.converged);
    const ProfileInterval i = interval_of(f, 1);
    EXPECT_TRUE(i.open_lower && i.open_upper);
    EXPECT_DOUBLE_EQ(i.lower, -bound);
    EXPECT_DOUBLE_EQ(i.upper, bound);
    EXPECT_LE(i.refits, 24);
  }
}

}  // namespace
}  // namespace raceway::fit
