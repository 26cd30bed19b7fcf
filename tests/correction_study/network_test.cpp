#include "tests/correction_study/network.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace correction_study {
namespace {

/// Three bodies in a row between a room and a cold wall, the first one heated.
Flows chain(double power, double room) {
  Flows f(3);
  f.join(0, 1, 8.0);
  f.join(1, 2, 20.0);
  f.expose(0, 1.5, room);
  f.expose(2, 12.0, 18.0);
  f.heat(0, power);
  return f;
}

const Eigen::Vector3d capacities(1000.0, 15000.0, 120000.0);

TEST(Network, RestIsTheSolutionOfTheBalanceOfEveryBody) {
  // Row by row by hand: heat in, less what goes to neighbours and surroundings.
  Eigen::Matrix3d G;
  G << 8.0 + 1.5, -8.0, 0.0, -8.0, 28.0, -20.0, 0.0, -20.0, 20.0 + 12.0;
  const Eigen::Vector3d in(150.0 + 1.5 * 23.0, 0.0, 12.0 * 18.0);
  const Eigen::VectorXd expected = G.partialPivLu().solve(in);
  EXPECT_LT((chain(150.0, 23.0).steady() - expected).norm(), 1e-10);
  EXPECT_LT(chain(150.0, 23.0).net(expected).norm(), 1e-10);
}

TEST(Network, RestIsWhatTimeLeadsTo) {
  const FlowsAt flows = [](double, const Eigen::VectorXd& T) {
    return chain(150.0 - 0.8 * (T[0] - 20.0), 23.0);  // friction falls as it warms
  };
  const Eigen::VectorXd start = Eigen::Vector3d::Constant(20.0);
  const Eigen::VectorXd late = advance(capacities, flows, 0.0, 400.0 * 3600.0, 300.0, start);
  EXPECT_LT((late - rest(flows, 0.0, start)).norm(), 1e-6);
}

TEST(Network, ABodyThatIsHeldByNothingHasNoRest) {
  Flows f(2);
  f.expose(0, 1.0, 20.0);
  EXPECT_THROW((void)f.steady(), std::invalid_argument);
}

TEST(Network, WhatIsStoredIsWhatCameIn) {
  const FlowsAt flows = [](double time, const Eigen::VectorXd& T) {
    return chain(200.0 * (1.0 + std::sin(time / 900.0)) - 0.5 * T[0],
                 21.0 + std::cos(time / 7000.0));
  };
  const auto coming_in = [&](double time, const Eigen::VectorXd& T) {
    const Flows f = flows(time, T);
    double power = f.heat_from_within();
    for (const Flows::Surroundings& s : f.surroundings())
      power += s.conductance * (s.temperature - T[s.body]);
    return power;
  };
  const Eigen::VectorXd start = Eigen::Vector3d(20.0, 21.0, 22.0);
  Eigen::VectorXd T = start;
  double came = 0.0, most = 0.0;
  const double h = 20.0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::VectorXd next = step(capacities, flows, i * h, h, T);
    came += 0.5 * h * (coming_in(i * h, T) + coming_in((i + 1) * h, next));
    most = std::max(most, std::abs(came));
    T = next;
  }
  EXPECT_GT(most, 1e5);
  EXPECT_NEAR(capacities.dot(T - start), came, 1e-7 * most);
}

TEST(Network, HalvingTheStepQuartersTheError) {
  const FlowsAt flows = [](double time, const Eigen::VectorXd& T) {
    return chain(200.0 * (1.0 + std::sin(time / 900.0)) - 0.5 * T[0], 21.0);
  };
  const Eigen::VectorXd start = Eigen::Vector3d::Constant(21.0);
  const auto at_end = [&](double h) { return advance(capacities, flows, 0.0, 3200.0, h, start); };
  const Eigen::VectorXd exact = at_end(0.5);
  const double coarse = (at_end(40.0) - exact).norm(), fine = (at_end(20.0) - exact).norm();
  EXPECT_NEAR(coarse / fine, 4.0, 0.2);
}

TEST(Network, OneBodyWarmsAsTheExponentialSays) {
  const FlowsAt flows = [](double, const Eigen::VectorXd&) {
    Flows f(1);
    f.expose(0, 2.0, 20.0);
    f.heat(0, 50.0);
    return f;
  };
  const Eigen::VectorXd capacity = Eigen::VectorXd::Constant(1, 4000.0);
  const Eigen::VectorXd T =
      advance(capacity, flows, 0.0, 3000.0, 5.0, Eigen::VectorXd::Constant(1, 20.0));
  EXPECT_NEAR(T[0], 20.0 + 25.0 * (1.0 - std::exp(-3000.0 / 2000.0)), 1e-5);
}

}  // namespace
}  // namespace correction_study
