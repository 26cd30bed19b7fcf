#include "tests/hidden_effect/oracle.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <cmath>
#include <span>
#include <vector>

#include "tests/hidden_effect/likelihood.h"

namespace hidden_effect {
namespace {

/// Part of y beyond the columns of A, squared and weighed by the inverse covariance.
double beyond(const Eigen::MatrixXd& A, const Eigen::VectorXd& y, const Eigen::MatrixXd& C) {
  const Eigen::MatrixXd inverse = C.inverse();
  const Eigen::VectorXd x = (A.transpose() * inverse * A).inverse() * A.transpose() * inverse * y;
  const Eigen::VectorXd r = y - A * x;
  return r.dot(inverse * r);
}

// Palmgren's torque is linear in f0 and z, so weighed least squares give each likelihood.
void expect_closed_form(const Rig& rig, const std::vector<double>& shape) {
  const auto n = static_cast<Eigen::Index>(rig.train.size());
  Eigen::MatrixXd base(n, 2), both(n, 3);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Reading& r = rig.train[static_cast<std::size_t>(i)];
    BaseLaw viscous = rig.setup.law, load = rig.setup.law;
    viscous.z = 0.0;
    load.f0 = 0.0;
    base.row(i) << torque(rig.bearing, viscous, r.point, {}),
        torque(rig.bearing, load, r.point, {});
    both.row(i) << base.row(i), shape[static_cast<std::size_t>(i)];
    y[i] = r.measured;
  }
  const Eigen::MatrixXd C = covariance_of_noise(rig, rig.train);
  const auto answer = ask_oracle(rig, rig.train);
  ASSERT_TRUE(answer);
  EXPECT_NEAR(answer->detection, beyond(base, y, C) - beyond(both, y, C), 1e-2);
  EXPECT_NEAR(answer->detected_from, 6.635, 1e-3);  // χ² of one degree, 1 %
}

TEST(Oracle, AgreesWithLeastSquaresForAConstantTorque) {
  const Rig rig = make_rig({.machine = machines().data(),
                            .hidden = {{.id = "torque-offset", .share = 0.02}},
                            .seed = 4});
  expect_closed_form(rig, std::vector<double>(rig.train.size(), 1.0));
}

TEST(Oracle, AgreesWithGeneralLeastSquaresForACreepingZeroInRunsWithOffsets) {
  const Rig rig = make_rig({.machine = machines().data(),
                            .plan = Plan::stairs,
                            .noise = Noise::run_offsets,
                            .detail = {.level = 0.01, .offset = 0.01},
                            .mistake = {.creep = 0.06},
                            .seed = 5});
  std::vector<double> hours;
  for (const Reading& r : rig.train) hours.push_back(std::fmod(r.point.time / 3600.0, 6.0));
  expect_closed_form(rig, hours);
}

Eigen::VectorXd column(std::span<const Reading> rows, double Reading::*member) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = rows[static_cast<std::size_t>(i)].*member;
  return out;
}

// The gain of the truth has the law of chi squared, shifted by lambda: mean 1 + lambda, variance
// 2 + 4 lambda.
TEST(Oracle, GainsOfATrueEffectScatterAroundLambda) {
  constexpr int rigs = 30;
  double sum = 0.0, lambda = 0.0;
  for (int i = 0; i < rigs; ++i) {
    const Rig rig = make_rig({.machine = machines().data(),
                              .hidden = {{.id = "cage-friction", .share = 0.05}},
                              .seed = static_cast<std::uint64_t>(100 + i)});
    const Eigen::MatrixXd C = covariance_of_noise(rig, rig.train);
    const Likelihood noisy(rig, rig.train, column(rig.train, &Reading::measured), C);
    const Likelihood exact(rig, rig.train, column(rig.train, &Reading::torque), C);
    sum += noisy.least({}) - noisy.least({.effects = {rig.hidden.front().effect}});
    lambda += exact.least({});
  }
  const double mean = lambda / rigs;
  EXPECT_GT(mean, 5.0);
  EXPECT_NEAR(sum / rigs, 1.0 + mean, 3.0 * std::sqrt((2.0 + 4.0 * mean) / rigs));
}

// A fit that stops early would count against the truth.
TEST(Oracle, NoFitOfTheTruthIsWorseThanTheTruth) {
  std::vector<std::vector<Wish>> hidden;
  for (const auto list : {catalogue_effects(), other_forms(), outside_effects()})
    for (const Effect& e : list) hidden.push_back({{.id = e.id, .share = 0.1}});
  hidden.push_back({{.id = "seal-friction"}, {.id = "film-self-heating"}});
  hidden.push_back({{.id = "thermal-preload"}, {.id = "mixed-lubrication"}});
  for (const std::vector<Wish>& wishes : hidden) {
    const Rig rig = make_rig({.machine = machines().data(), .hidden = wishes, .seed = 6});
    const Eigen::MatrixXd C = covariance_of_noise(rig, rig.train);
    const Eigen::VectorXd readings = column(rig.train, &Reading::measured),
                          noise = readings - column(rig.train, &Reading::torque);
    Hypothesis truth;
    for (const Hidden& h : rig.hidden) truth.effects.push_back(h.effect);
    EXPECT_LT(Likelihood(rig, rig.train, readings, C).least(truth),
              noise.dot(C.llt().solve(noise)) + 0.01)
        << wishes.front().id;
  }
}

TEST(Oracle, KnowsTheCovarianceOfTheNoise) {
  // The whitened noise of a rig has a variance of one for each reading.
  for (const Noise noise :
       {Noise::independent, Noise::run_offsets, Noise::autoregressive, Noise::absolute}) {
    double square = 0.0, count = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Rig rig = make_rig({.machine = machines().data(), .noise = noise, .seed = seed});
      const Eigen::MatrixXd C = covariance_of_noise(rig, rig.train);
      const Eigen::VectorXd r =
          column(rig.train, &Reading::measured) - column(rig.train, &Reading::torque);
      square += r.dot(C.llt().solve(r));
      count += static_cast<double>(r.size());
    }
    EXPECT_NEAR(square / count, 1.0, 4.0 * std::sqrt(2.0 / count)) << name(noise);
  }
}

TEST(Oracle, FindsThatNoEntryFitsAnEffectOutsideTheCatalogue) {
  const auto excess = [](std::string_view id, double share) {
    const Rig rig =
        make_rig({.machine = machines().data(), .hidden = {{.id = id, .share = share}}, .seed = 7});
    return ask_oracle(rig, rig.train)->misfit_excess;
  };
  EXPECT_GT(excess("cage-resonance", 0.1), 100.0);
  EXPECT_LT(excess("cage-resonance", 0.001), 0.0);
  EXPECT_FALSE(excess("spin-friction", 0.1));
}

TEST(Oracle, HasNoAnswerWhereItKnowsNoFormula) {
  const Rig rig = make_rig({.machine = machines().data(), .mistake = {.pair_preload = 1500.0}});
  EXPECT_FALSE(ask_oracle(rig, rig.train));
}

}  // namespace
}  // namespace hidden_effect
