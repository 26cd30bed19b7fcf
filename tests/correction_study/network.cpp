#include "tests/correction_study/network.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace correction_study {
namespace {

// Change by the last iteration [K], which leaves a hundredth of it.
constexpr double settled = 1e-7;
constexpr int most_iterations = 200;

}  // namespace

Flows::Flows(int bodies)
    : conductance_(Eigen::MatrixXd::Zero(bodies, bodies)), inflow_(Eigen::VectorXd::Zero(bodies)) {
  surroundings_.reserve(2 * static_cast<std::size_t>(bodies));
}

void Flows::join(int a, int b, double conductance) {
  conductance_(a, a) += conductance;
  conductance_(b, b) += conductance;
  conductance_(a, b) -= conductance;
  conductance_(b, a) -= conductance;
}

void Flows::expose(int body, double conductance, double temperature) {
  conductance_(body, body) += conductance;
  inflow_[body] += conductance * temperature;
  surroundings_.push_back({body, conductance, temperature});
}

void Flows::heat(int body, double power) {
  inflow_[body] += power;
  from_within_ += power;
}

Eigen::VectorXd Flows::net(const Eigen::VectorXd& temperature) const {
  return inflow_ - conductance_ * temperature;
}

Eigen::VectorXd Flows::steady() const {
  const Eigen::LDLT<Eigen::MatrixXd> solver(conductance_);
  if (solver.vectorD().minCoeff() <= 1e-12 * solver.vectorD().maxCoeff())
    throw std::invalid_argument("a body has no way to its surroundings");
  return solver.solve(inflow_);
}

Eigen::VectorXd step(const Eigen::VectorXd& capacity, const FlowsAt& flows, double time,
                     double length, const Eigen::VectorXd& temperature) {
  const Eigen::VectorXd held = capacity / length;
  const Eigen::VectorXd known =
      held.cwiseProduct(temperature) + 0.5 * flows(time, temperature).net(temperature);
  Eigen::VectorXd next = temperature;
  for (int i = 0; i < most_iterations; ++i) {
    const Flows after = flows(time + length, next);
    Eigen::MatrixXd left = 0.5 * after.conductance();
    left.diagonal() += held;
    const Eigen::VectorXd better =
        Eigen::LLT<Eigen::MatrixXd>(left).solve(known + 0.5 * after.inflow());
    const double change = (better - next).lpNorm<Eigen::Infinity>();
    next = better;
    if (change < settled) return next;
  }
  throw std::runtime_error("a step of the network does not settle");
}

Eigen::VectorXd advance(const Eigen::VectorXd& capacity, const FlowsAt& flows, double time,
                        double length, double longest, Eigen::VectorXd temperature) {
  const int steps = std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
  const double h = length / steps;
  for (int i = 0; i < steps; ++i) temperature = step(capacity, flows, time + i * h, h, temperature);
  return temperature;
}

Eigen::VectorXd rest(const FlowsAt& flows, double time, Eigen::VectorXd start) {
  for (int i = 0; i < most_iterations; ++i) {
    const Eigen::VectorXd next = flows(time, start).steady();
    const double change = (next - start).lpNorm<Eigen::Infinity>();
    start = next;
    if (change < settled) return start;
  }
  throw std::runtime_error("the network finds no rest");
}

}  // namespace correction_study
