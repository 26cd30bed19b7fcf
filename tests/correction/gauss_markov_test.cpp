#include "correction/gauss_markov.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

namespace raceway::correction {
namespace {

constexpr double reading_std = 0.5;

/// Readings of a sum of unknowns, and what they say of it by one dense solution.
struct DenseRegression {
  std::vector<Unknown> unknowns{};
  std::vector<double> time{}, reading{};
  std::vector<std::vector<double>> weights{};

  [[nodiscard]] double kernel(double t, const std::vector<double>& h, double u,
                              const std::vector<double>& g) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      sum += h[k] * g[k] * unknowns[k].std * unknowns[k].std *
             std::exp(-std::abs(t - u) / unknowns[k].memory);
    return sum;
  }

  [[nodiscard]] UnknownsFilter::Expected at(double t, const std::vector<double>& h) const {
    const auto n = static_cast<Eigen::Index>(time.size());
    Eigen::MatrixXd all(n, n);
    Eigen::VectorXd with(n), y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto a = static_cast<std::size_t>(i);
      y[i] = reading[a];
      with[i] = kernel(t, h, time[a], weights[a]);
      for (Eigen::Index j = 0; j < n; ++j) {
        const auto b = static_cast<std::size_t>(j);
        all(i, j) = kernel(time[a], weights[a], time[b], weights[b]);
      }
      all(i, i) += reading_std * reading_std;
    }
    const Eigen::LDLT<Eigen::MatrixXd> solved(all);
    return {.mean = with.dot(solved.solve(y)),
            .variance = kernel(t, h, t, h) - with.dot(solved.solve(with))};
  }

  [[nodiscard]] UnknownsFilter filtered() const {
    UnknownsFilter filter(unknowns);
    double now = 0.0;
    for (std::size_t k = 0; k < time.size(); ++k) {
      filter.advance(time[k] - now);
      now = time[k];
      filter.learn(weights[k], reading[k], reading_std);
    }
    return filter;
  }
};

DenseRegression made(std::vector<Unknown> unknowns) {
  DenseRegression r{.unknowns = std::move(unknowns)};
  const double times[] = {0, 40, 55, 200, 210, 480};
  for (const double t : times) {
    r.time.push_back(t);
    r.reading.push_back(3.0 * std::sin(t / 70.0) + 0.01 * t);
    r.weights.push_back({1.0, 1.0, std::cos(t / 90.0), 0.02 * t});
  }
  return r;
}

/// The dense solution of the regression is another way to the same numbers.
TEST(UnknownsFilter, IsTheRegressionByAGaussianProcess) {
  const DenseRegression r = made({{.name = "constant", .std = 10.0},
                                  {.name = "fast", .std = 2.0, .memory = 60.0},
                                  {.name = "slow", .std = 1.0, .memory = 900.0},
                                  {.name = "gain", .std = 0.3, .memory = 5000.0}});
  const UnknownsFilter filter = r.filtered();
  for (const double ahead : {0.0, 20.0, 300.0}) {
    const std::vector<double> h{1.0, 1.0, -0.4, 7.0};
    const UnknownsFilter::Expected is = filter.expected(h, ahead), must = r.at(480 + ahead, h);
    EXPECT_NEAR(is.mean, must.mean, 1e-10) << ahead;
    EXPECT_NEAR(is.variance, must.variance, 1e-10) << ahead;
  }
}

/// By hand: kernel 9 + 4 exp(-|t - t'|/100), readings 5 and 4 at 0 and 50 with a noise of 0.5; at
/// 120 by Cramer's rule in another program.
TEST(UnknownsFilter, AgreesWithTwoReadingsByHand) {
  DenseRegression r{
      .unknowns = {{.name = "constant", .std = 3.0}, {.name = "fast", .std = 2.0, .memory = 100.0}},
      .time = {0.0, 50.0},
      .reading = {5.0, 4.0},
      .weights = {{1.0, 1.0}, {1.0, 1.0}}};
  const UnknownsFilter::Expected e = r.filtered().expected(std::vector{1.0, 1.0}, 70.0);
  EXPECT_NEAR(e.mean, 3.6502067460909, 1e-12);
  EXPECT_NEAR(e.variance, 3.73339273799333, 1e-12);
}

/// Recursive least squares: constants learnt one reading at a time are those of the normal
/// equations (H'H + r²/s²) x = H'y.
TEST(UnknownsFilter, OfConstantsIsLeastSquaresInClosedForm) {
  const DenseRegression r = made({{.name = "a", .std = 4.0},
                                  {.name = "b", .std = 3.0},
                                  {.name = "c", .std = 2.0},
                                  {.name = "d", .std = 1.0}});
  const UnknownsFilter filter = r.filtered();
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < r.time.size(); ++k) {
    const Eigen::Map<const Eigen::Vector4d> h(r.weights[k].data());
    normal += h * h.transpose();
    right += r.reading[k] * h;
  }
  for (Eigen::Index k = 0; k < 4; ++k) {
    const double s = r.unknowns[static_cast<std::size_t>(k)].std;
    normal(k, k) += reading_std * reading_std / (s * s);
  }
  const Eigen::Vector4d x = normal.ldlt().solve(right);
  const Eigen::Matrix4d covariance = reading_std * reading_std * normal.inverse();
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(filter.value(k), x[static_cast<Eigen::Index>(k)], 1e-10);
    EXPECT_NEAR(filter.std(k),
                std::sqrt(covariance(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k))),
                1e-10);
  }
}

TEST(UnknownsFilter, WhatIsNotReadReturnsAndIsForgotten) {
  UnknownsFilter filter({{.name = "gain", .std = 2.0, .memory = 100.0}});
  filter.learn(std::vector{1.0}, 3.0, 1e-3);
  const double learnt = filter.value(0);
  EXPECT_NEAR(learnt, 3.0, 1e-5);
  filter.advance(100.0);
  EXPECT_NEAR(filter.value(0), learnt * std::exp(-1.0), 1e-12);
  filter.advance(1e5);
  EXPECT_NEAR(filter.value(0), 0.0, 1e-12);
  EXPECT_NEAR(filter.std(0), 2.0, 1e-12);
}

/// A variance of q² for each second.
TEST(UnknownsFilter, AWalkIsLessSureByTheRootOfTime) {
  UnknownsFilter filter({{.name = "zero", .std = 1.0, .walk = 0.25, .first_std = 3.0}});
  EXPECT_DOUBLE_EQ(filter.std(0), 3.0);
  EXPECT_DOUBLE_EQ(filter.expected(std::vector{1.0}, 64.0).variance, 9.0 + 4.0);
  filter.advance(64.0);
  EXPECT_DOUBLE_EQ(filter.std(0), std::sqrt(13.0));
}

/// Of a rate v with memory T the unknown moves by v T (1 - exp(-t/T)); one long step is as many
/// short ones; and long after T it is a random walk by 2 s² T.
TEST(UnknownsFilter, ARateMovesWhatItIsTheRateOf) {
  const std::vector<Unknown> unknowns{
      {.name = "zero", .std = 1.0},
      {.name = "drift", .std = 0.02, .memory = 300.0, .first_std = 0.5, .rate_of = 0}};
  const std::vector<double> of_zero{1.0, 0.0}, of_both{1.0, 40.0};
  UnknownsFilter one(unknowns);
  one.learn(of_zero, 2.0, 0.1);
  one.learn(std::vector{0.0, 1.0}, 0.3, 0.1);
  UnknownsFilter many = one;
  const double zero = one.value(0), rate = one.value(1);
  const UnknownsFilter::Expected ahead = one.expected(of_both, 200.0);
  one.advance(200.0);
  for (int k = 0; k < 400; ++k) many.advance(0.5);
  EXPECT_NEAR(one.value(0), zero + rate * 300.0 * (1.0 - std::exp(-200.0 / 300.0)), 1e-12);
  EXPECT_NEAR(ahead.mean, one.value(0) + 40.0 * one.value(1), 1e-12);
  const UnknownsFilter::Expected now = one.expected(of_both, 0.0),
                                 same = many.expected(of_both, 0.0);
  EXPECT_NEAR(now.variance, ahead.variance, 1e-9 * ahead.variance);
  EXPECT_NEAR(same.mean, now.mean, 1e-9);
  EXPECT_NEAR(same.variance, now.variance, 1e-9 * now.variance);
  const double far = 3e6, further = 4e6;
  EXPECT_NEAR((one.expected(of_zero, further).variance - one.expected(of_zero, far).variance) / 1e6,
              2.0 * 0.02 * 0.02 * 300.0, 1e-9);
}

/// What the bound keeps from one is moved to the others as far as they are of one mind.
TEST(UnknownsFilter, KeepsBoundsAndExplainsTheRestOtherwise) {
  UnknownsFilter filter({{.name = "gain", .std = 1.0, .bound = 0.5}, {.name = "zero", .std = 1.0}});
  filter.learn(std::vector{1.0, 1.0}, 4.0, 1e-3);
  EXPECT_DOUBLE_EQ(filter.value(0), 0.5);
  EXPECT_TRUE(filter.at_bound(0));
  EXPECT_NEAR(filter.value(1), 3.5, 1e-4);
  EXPECT_FALSE(filter.at_bound(1));
}

TEST(UnknownsFilter, RefusesASizeOrMemoryThatIsNone) {
  EXPECT_THROW(UnknownsFilter({{.name = "a", .std = 0.0}}), std::invalid_argument);
  EXPECT_THROW(UnknownsFilter({{.name = "a", .std = 1.0, .memory = 0.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::correction
