#pragma once

#include <Eigen/SparseCholesky>

#include "spindle/bearing_coupling.h"

namespace raceway::spindle {

enum class NewtonStatus { converged, no_balance, diverged };

/// Solves  A T = r + P y(s),  s = F T + s0  for the temperatures of all cells.
///
/// A is factorised once per time step. What is nonlinear, the sets, sees a dozen numbers s and
/// gives half a dozen y, so that Newton's method runs on
///
///   s = F A⁻¹ r + s0 + M y(s),   M = F A⁻¹ P
///
/// alone: the cells are eliminated by Woodbury's identity, no derivative of them is formed. dy/ds
/// is kept from step to step and renewed where it converges slowly.
class CoupledNewton {
 public:
  CoupledNewton(const HeatPaths& paths, BearingCoupling* coupling);

  /// A = capacity_factor C + G; false where A is not positive definite: heat has no way out.
  [[nodiscard]] bool factorise(const HeatPaths& paths, double capacity_factor);
  /// The temperatures, and y at them in `given`, which is where the search begins.
  [[nodiscard]] NewtonStatus solve(const Vector& right, Vector& temperatures, Vector& given,
                                   Vector& felt);
  [[nodiscard]] Vector solve_linear(const Vector& right) const { return ldlt_.solve(right); }
  /// Drops the derivatives, after inputs of the sets have changed.
  void forget_derivatives() { known_ = false; }
  /// Largest real gain of the loop heat -> temperature -> preload -> heat at the last solution: at
  /// 1 it runs away.
  [[nodiscard]] double gain(const Vector& felt, const Vector& given);

 private:
  [[nodiscard]] bool renew(const Vector& felt, const Vector& given);

  BearingCoupling* coupling_;
  ConductanceMatrix matrix_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> ldlt_;
  Matrix reach_;     // A⁻¹ P
  Matrix response_;  // M
  Matrix jacobian_;  // dy/ds
  bool known_ = false;
};

}  // namespace raceway::spindle
