#pragma once

#include "spindle/bearing_coupling.h"
#include "spindle/conductance_solver.h"

namespace raceway::spindle {

enum class NewtonStatus { converged, no_balance, diverged };

/// Solves A T = r + P y(s), s = F T + s0 for the temperatures of all cells.
///
/// A = L D Lᵀ is factorised once per time step. The nonlinear part, the sets, maps about a dozen
/// numbers s to half a dozen numbers y. Newton's method therefore runs only on
///
///   s = F A⁻¹ r + s0 + M y(s),   M = F A⁻¹ P
///
/// Woodbury's identity eliminates the cells, so derivatives with respect to cell temperatures are
/// not needed. With Φ = L⁻¹ Fᵀ, some columns of which are Π = L⁻¹ P,
///
///   F A⁻¹ r = Φᵀ D⁻¹ L⁻¹ r,   M = Φᵀ D⁻¹ Π
///
/// need only forward substitutions; only T needs a back substitution. The solver keeps dy/ds
/// between time steps, updates it after each Newton step (Broyden 1965), and computes it again when
/// convergence is slow.
class CoupledNewton {
 public:
  CoupledNewton(const HeatPaths& paths, BearingCoupling* coupling);

  /// Factorises A = capacity_factor C + G. Returns false if A is not positive definite: a
  /// body has neither heat capacity nor a path for heat to leave, or a number is not finite.
  [[nodiscard]] bool factorise(const HeatPaths& paths, double capacity_factor);
  /// Computes the temperatures. `given` contains the start value of y and receives the result.
  [[nodiscard]] NewtonStatus solve(const Vector& right, Vector& temperatures, Vector& given,
                                   Vector& felt);
  [[nodiscard]] Vector solve_linear(const Vector& right) const { return solver_.solve(right); }
  /// Drops the derivatives; call it after a change of the inputs of the sets.
  void forget_derivatives() { known_ = false; }
  /// Returns the largest real gain of the loop heat -> temperature -> preload -> heat at the last
  /// solution. At a gain of 1, thermal runaway begins.
  [[nodiscard]] double gain(const Vector& felt, const Vector& given);

 private:
  [[nodiscard]] bool renew(const Vector& felt, const Vector& given);
  [[nodiscard]] Vector step_of(const Vector& miss) const;

  BearingCoupling* coupling_;
  ConductanceSolver solver_;
  Matrix felt_;                             // Fᵀ in the order of elimination
  Matrix reach_;                            // Φ
  Matrix given_;                            // Π
  std::vector<Eigen::Index> given_bodies_;  // rows of Π that are not zero
  Matrix response_;                         // M
  Matrix jacobian_;                         // dy/ds
  bool known_ = false;
};

}  // namespace raceway::spindle
