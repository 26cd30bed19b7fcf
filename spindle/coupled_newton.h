#pragma once

#include "spindle/bearing_coupling.h"
#include "spindle/conductance_solver.h"

namespace raceway::spindle {

enum class NewtonStatus { converged, no_balance, diverged };

/// Solves A T = r + P y(s) with s = F T + s0 for the temperatures T of all cells. The vector s
/// contains the temperatures and the elongation on which the bearing heat y depends.
/// BearingCoupling explains s and y, and contains F and s0. The matrix A contains heat capacities
/// and conductances, see factorise(). The matrix P divides y among the cells, and r is the
/// right-hand side without bearing heat.
///
/// A = L D Lᵀ is factorised once per time step. Only the bearing heat y(s) is nonlinear, and s and
/// y have few elements. Newton's method therefore solves only
///
///   s = F A⁻¹ r + s0 + M y(s),   M = F A⁻¹ P
///
/// Both terms with A⁻¹ need only forward substitutions with L:
///
///   F A⁻¹ r = Φᵀ D⁻¹ L⁻¹ r,   M = Φᵀ D⁻¹ Π,   Φ = L⁻¹ Fᵀ,   Π = L⁻¹ P
///
/// The solver keeps the Jacobian dy/ds between time steps and updates it after each Newton step
/// (Broyden 1965). If convergence is slow, the solver computes the Jacobian again.
class CoupledNewton {
 public:
  CoupledNewton(const HeatPaths& paths, BearingCoupling* coupling);

  /// Factorises A = capacity_factor C + G, with the heat capacities C and the conductances G.
  /// Returns false if A is not positive definite. This is the case if a body has neither heat
  /// capacity nor a path by which heat can leave, or if a value is not finite.
  [[nodiscard]] bool factorise(const HeatPaths& paths, double capacity_factor);
  /// Computes `temperatures` for the right-hand side r = `right`. `given` and `felt` contain start
  /// values of y and s, and receive the solution. If the status is not `converged`, the three
  /// vectors do not change.
  [[nodiscard]] NewtonStatus solve(const Vector& right, Vector& temperatures, Vector& given,
                                   Vector& felt);
  [[nodiscard]] Vector solve_linear(const Vector& right) const { return solver_.solve(right); }
  /// Discards the Jacobian dy/ds. Call this function after a change of speed or load.
  void forget_derivatives() { known_ = false; }
  /// Returns the gain of the feedback loop heat -> temperature -> preload -> heat at s = `felt` and
  /// y = `given`: the largest real eigenvalue of M dy/ds [1]. A gain of 1 or more means thermal
  /// runaway. The result is NaN without bearings, or if the bearing sets have no equilibrium near
  /// `felt`.
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
