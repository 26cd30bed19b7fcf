#include "spindle/coupled_newton.h"

#include <algorithm>
#include <cmath>

#include "algebra/detail/decompositions.h"

namespace raceway::spindle {
namespace {

/// On s, in K and um: what is missed, or the step that is left. Of rings that hardly anything cools
/// the rounding of their heat alone misses more.
constexpr double newton_tolerance = 1e-8;
/// What s may move by in one step: a bearing that warms by 20 K, or the like in um, is another one.
constexpr double longest_newton_step = 25.0;
constexpr int most_iterations = 60, most_halvings = 12;
/// Errors that shrink by less than this per step ask for new derivatives.
constexpr double slow = 0.2;

}  // namespace

CoupledNewton::CoupledNewton(const HeatPaths& paths, BearingCoupling* coupling)
    : coupling_(coupling), matrix_(paths) {
  ldlt_.analyzePattern(matrix_.fill(paths, 1.0));
}

bool CoupledNewton::factorise(const HeatPaths& paths, double capacity_factor) {
  ldlt_.factorize(matrix_.fill(paths, capacity_factor));
  if (ldlt_.info() != Eigen::Success || !(ldlt_.vectorD().minCoeff() > 0.0)) return false;
  if (coupling_) {
    reach_ = ldlt_.solve(coupling_->given());
    response_ = coupling_->felt_rows() * reach_;
  }
  return true;
}

bool CoupledNewton::renew(const Vector& felt, const Vector& given) {
  known_ = coupling_->differentiate(felt, given, jacobian_);
  return known_;
}

NewtonStatus CoupledNewton::solve(const Vector& right, Vector& temperatures, Vector& given,
                                  Vector& felt) {
  const Vector base = ldlt_.solve(right);
  if (!coupling_) {
    temperatures = base;
    return NewtonStatus::converged;
  }
  const Vector free = coupling_->felt(base);
  Vector s = felt, y = given;
  if (!coupling_->evaluate(s, y)) return NewtonStatus::no_balance;
  Vector miss = free + response_ * y - s;
  double error = miss.lpNorm<Eigen::Infinity>();
  bool fresh = false, arrived = error <= newton_tolerance;
  for (int k = 0; k < most_iterations && !arrived; ++k) {
    if (!known_) {
      if (!renew(s, y)) return NewtonStatus::no_balance;
      fresh = true;
    }
    const Matrix slope = Matrix::Identity(s.size(), s.size()) - response_ * jacobian_;
    Vector step = algebra::solve_square(slope, miss);
    if (!step.allFinite()) return NewtonStatus::diverged;
    const double length = step.lpNorm<Eigen::Infinity>();
    if (length <= newton_tolerance) {
      arrived = true;
      break;
    }
    if (length > longest_newton_step) step *= longest_newton_step / length;
    double error_after = error;
    bool better = false;
    for (int half = 0; half < most_halvings; ++half, step *= 0.5) {
      const Vector next = s + step;
      Vector heat = y;
      if (!coupling_->evaluate(next, heat)) continue;
      const Vector left = free + response_ * heat - next;
      error_after = left.lpNorm<Eigen::Infinity>();
      if (!(error_after < error) && half + 1 < most_halvings && fresh) continue;
      if (!(error_after < error)) break;
      s = next, y = heat, miss = left;
      better = true;
      break;
    }
    if (!better) {
      if (fresh) return NewtonStatus::diverged;
      known_ = false;
      if (!coupling_->evaluate(s, y)) return NewtonStatus::no_balance;
      continue;
    }
    if (error_after > slow * error) known_ = false;
    fresh = false;
    error = error_after;
    arrived = error <= newton_tolerance;
  }
  if (!arrived) return NewtonStatus::diverged;
  temperatures = base + reach_ * y;
  given = y;
  felt = coupling_->felt(temperatures);
  return NewtonStatus::converged;
}

double CoupledNewton::gain(const Vector& felt, const Vector& given) {
  if (!coupling_ || !renew(felt, given)) return unset;
  const Eigen::VectorXcd values = algebra::eigenvalues(response_ * jacobian_);
  double largest = -1e300;
  for (const std::complex<double>& v : values)
    if (std::abs(v.imag()) < 1e-9) largest = std::max(largest, v.real());
  return largest;
}

}  // namespace raceway::spindle
