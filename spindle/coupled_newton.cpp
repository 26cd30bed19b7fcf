#include "spindle/coupled_newton.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
/// Shorter steps tell nothing of the derivatives.
constexpr double least_told = 1e3 * newton_tolerance;

}  // namespace

CoupledNewton::CoupledNewton(const HeatPaths& paths, BearingCoupling* coupling)
    : coupling_(coupling), solver_(paths) {
  if (!coupling_) return;
  felt_ = solver_.in_order(Matrix(coupling_->felt_rows().transpose()));
  // No term of Π cancels another: what is zero with all ways open is zero always.
  HeatPaths open = paths;
  for (HeatPaths::Link& way : open.links) way.conductance = 1.0;
  if (!factorise(open, 1.0))
    throw std::invalid_argument("a part of the spindle has no heat capacity");
  for (Eigen::Index k = 0; k < given_.rows(); ++k)
    if ((given_.row(k).array() != 0.0).any()) given_bodies_.push_back(k);
}

bool CoupledNewton::factorise(const HeatPaths& paths, double capacity_factor) {
  if (!solver_.factorise(paths, capacity_factor)) return false;
  if (coupling_) {
    reach_ = solver_.first_half(felt_);
    given_ = reach_(Eigen::all, coupling_->given_rows());
    const Matrix given = (solver_.inverse().asDiagonal() * given_)(given_bodies_, Eigen::all);
    response_ = reach_(given_bodies_, Eigen::all).transpose() * given;
  }
  return true;
}

bool CoupledNewton::renew(const Vector& felt, const Vector& given) {
  known_ = coupling_->differentiate(felt, given, jacobian_);
  return known_;
}

/// (1 - M J)⁻¹ miss = miss + M (1 - J M)⁻¹ J miss: there are fewer y than s.
Vector CoupledNewton::step_of(const Vector& miss) const {
  const Matrix slope = Matrix::Identity(jacobian_.rows(), jacobian_.rows()) - jacobian_ * response_;
  return miss + response_ * algebra::solve_square(slope, jacobian_ * miss);
}

NewtonStatus CoupledNewton::solve(const Vector& right, Vector& temperatures, Vector& given,
                                  Vector& felt) {
  const Vector first = solver_.first_half(solver_.in_order(right));
  if (!coupling_) {
    temperatures = solver_.second_half(first);
    return NewtonStatus::converged;
  }
  const Vector free =
      coupling_->felt_offset() + reach_.transpose() * solver_.inverse().cwiseProduct(first);
  Vector s = felt, y = given;
  Vector miss = free + response_ * y - s;
  double error = miss.lpNorm<Eigen::Infinity>();
  bool fresh = false, arrived = error <= newton_tolerance;
  bool evaluated = false;  // y at s; until then it is that of the solution before
  for (int k = 0; k < most_iterations && !arrived; ++k) {
    if (!known_) {
      if (!renew(s, y)) return NewtonStatus::no_balance;
      fresh = true;
    }
    Vector step = step_of(miss);
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
      // Broyden's update, of steps that stand out of the tolerance.
      if (const double moved = step.squaredNorm(); moved > least_told * least_told)
        jacobian_ += (heat - y - jacobian_ * step) * (step.transpose() / moved);
      s = next, y = heat, miss = left;
      better = evaluated = true;
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
  if (!evaluated) {
    if (!coupling_->evaluate(s, y)) return NewtonStatus::no_balance;
    miss = free + response_ * y - s;
  }
  // The last step, below the tolerance, needs no balance: by the derivatives it is exact.
  if (known_) y += jacobian_ * step_of(miss);
  if (!y.allFinite()) return NewtonStatus::diverged;
  temperatures = solver_.second_half(first + given_ * y);
  given = y;
  felt = free + response_ * y;
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
