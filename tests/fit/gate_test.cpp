#include "verdict/gate.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "fit/whitening.h"

namespace raceway::fit {
namespace {

Eigen::MatrixXd gaussian(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  Eigen::MatrixXd m(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    for (Eigen::Index i = 0; i < rows; ++i) m(i, k) = gauss(random);
  return m;
}

TEST(Whitening, IsTheInverseRootOfItsCovariance) {
  RowOrder order;
  order.has_time = order.has_runs = true;
  constexpr Eigen::Index rows = 12;
  std::vector<double> time;
  for (Eigen::Index i = 0; i < rows; ++i) {
    order.step.push_back(i == 0 ? std::numeric_limits<double>::infinity() : i % 3 == 0 ? 2.0 : 1.0);
    order.new_run.push_back(i % 4 == 0);
    time.push_back(i == 0 ? 0.0 : time.back() + order.step.back());
  }
  Eigen::VectorXd std(rows);
  for (Eigen::Index i = 0; i < rows; ++i) std[i] = 1.0 + 0.1 * static_cast<double>(i);
  constexpr double phi = 0.7, share = 0.3;
  Eigen::MatrixXd covariance(rows, rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index k = 0; k < rows; ++k) {
      const double apart =
          std::abs(time[static_cast<std::size_t>(i)] - time[static_cast<std::size_t>(k)]);
      covariance(i, k) =
          std[i] * std[k] * ((1.0 - share) * std::pow(phi, apart) + (i / 4 == k / 4 ? share : 0.0));
    }
  const Whitening whitening(std, order, phi, share);
  const Eigen::MatrixXd w = whitening(Eigen::MatrixXd(Eigen::MatrixXd::Identity(rows, rows)));
  EXPECT_LT((w * covariance * w.transpose() - Eigen::MatrixXd::Identity(rows, rows)).norm(), 1e-12);
  EXPECT_NEAR(whitening.log_determinant(), std::log(covariance.determinant()), 1e-10);
}

TEST(Gate, DoesNotSeeWhatBaseParametersCanDo) {
  const Eigen::MatrixXd tangent = gaussian(120, 3, 1), surface = gaussian(120, 15, 2),
                        scores = gaussian(120, 20, 3);
  const Eigen::VectorXd residual = gaussian(120, 1, 4).col(0);
  const std::vector<bool> one_sided(20, true);
  const verdict::NullDraws draws(20);
  const verdict::Gate plain =
      verdict::open_gate(tangent, residual, surface, scores, one_sided, 80.0, draws);
  const Eigen::VectorXd moved = residual + tangent * Eigen::Vector3d(7.0, -3.0, 11.0);
  const verdict::Gate shifted =
      verdict::open_gate(tangent, moved, surface, scores, one_sided, 80.0, draws);
  EXPECT_NEAR(shifted.p_value(), plain.p_value(), 1e-8);
  EXPECT_LT((shifted.scores - plain.scores).norm(), 1e-8);
  EXPECT_EQ(shifted.largest, plain.largest);
}

TEST(Gate, AlarmsOnceInAHundredTimesOnPureNoise) {
  const Eigen::MatrixXd tangent = gaussian(120, 3, 5), surface = gaussian(120, 15, 6);
  Eigen::MatrixXd scores = gaussian(120, 25, 7);
  for (Eigen::Index k = 1; k < scores.cols(); ++k) scores.col(k) += 1.5 * scores.col(0);
  std::vector<bool> one_sided(25, false);
  for (std::size_t k = 0; k < 15; ++k) one_sided[k] = true;
  const verdict::NullDraws draws(25);
  const Eigen::MatrixXd noise = gaussian(120, 1000, 8);
  int alarms = 0;
  for (Eigen::Index s = 0; s < noise.cols(); ++s)
    if (verdict::open_gate(tangent, noise.col(s), surface, scores, one_sided, 1e6, draws).alarm())
      ++alarms;
  EXPECT_LE(alarms, 20);  // 10 expected at most, as the two tests are not independent
  EXPECT_GE(alarms, 2);
}

TEST(Gate, CallsAnAliasOfTheBaseInvisible) {
  const Eigen::MatrixXd tangent = gaussian(60, 2, 9);
  Eigen::MatrixXd scores(60, 1);
  scores.col(0) = tangent * Eigen::Vector2d(1.0, 2.0) + 1e-3 * gaussian(60, 1, 10).col(0);
  const verdict::Gate gate =
      verdict::open_gate(tangent, gaussian(60, 1, 11).col(0), gaussian(60, 15, 12), scores, {true},
                         40.0, verdict::NullDraws(1));
  EXPECT_LT(gate.visibility[0], verdict::invisible);
  EXPECT_EQ(gate.largest, -1);
  EXPECT_EQ(gate.score_p_value, 1.0);
}

TEST(Gate, FollowsTheUnionOfTheScores) {
  // Independent scores: the largest of m has p = 1 - (1 - tail)^m.
  const verdict::NullDraws draws(10);
  const double p =
      draws.p_value(Eigen::MatrixXd::Identity(10, 10), std::vector<bool>(10, true), 1e9, 2.5);
  EXPECT_NEAR(p, 1.0 - std::pow(1.0 - 0.0062097, 10), 0.006);
}

}  // namespace
}  // namespace raceway::fit
