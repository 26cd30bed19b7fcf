#pragma once

#include <Eigen/SparseCholesky>

#include "spindle/bearing_coupling.h"

namespace raceway::spindle {

enum class NewtonStatus { converged, no_balance, diverged };

/// Solves A T = r + P y(s), s = F T + s0 for the temperatures of all cells.
///
/// A is factorised once per time step. The nonlinear part, the sets, maps about a dozen numbers s
/// to half a dozen numbers y. Newton's method therefore runs only on
///
///   s = F A⁻¹ r + s0 + M y(s),   M = F A⁻¹ P
///
/// Woodbury's identity eliminates the cells, so derivatives with respect to cell temperatures are
/// not needed. dy/ds is kept between time steps and is computed again when convergence is slow.
class CoupledNewton {
 public:
  CoupledNewton(const HeatPaths& paths, BearingCoupling* coupling);

  /// Factorises A = capacity_factor C + G. Returns false if A is not positive definite, which means
  /// that heat cannot leave.
  [[nodiscard]] bool factorise(const HeatPaths& paths, double capacity_factor);
  /// Computes the temperatures. `given` contains the start value of y and receives the result.
  [[nodiscard]] NewtonStatus solve(const Vector& right, Vector& temperatures, Vector& given,
                                   Vector& felt);
  [[nodiscard]] Vector solve_linear(const Vector& right) const { return ldlt_.solve(right); }
  /// Drops the derivatives; call it after a change of the inputs of the sets.
  void forget_derivatives() { known_ = false; }
  /// Returns the largest real gain of the loop heat -> temperature -> preload -> heat at the last
  /// solution. At a gain of 1 the spindle runs away thermally.
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
