#pragma once

#include <string_view>

#include "record/units.h"

namespace raceway::bearing {

enum class SolveStatus {
  not_run,
  converged,
  no_equilibrium,   ///< no equilibrium was found; see SolveReport::certain
  iteration_limit,  ///< the solver reached the limit of Newton steps
  singular,         ///< singular stiffness: a displacement is undetermined
  not_finite,       ///< a value of the solution is infinite or NaN
};

/// Returns the name of the status in the JSON results, such as "no_equilibrium".
[[nodiscard]] std::string_view name(SolveStatus status);

/// Status and accuracy of a solution. A new report has the status `not_run`. Only the solver sets
/// `converged`.
struct SolveReport {
  SolveStatus status = SolveStatus::not_run;
  int iterations = 0;       ///< number of all Newton steps
  double residual = unset;  ///< largest imbalance of ring and balls, relative to the load [1]
  /// Largest component of the difference between the applied load and the sum of the reported ball
  /// forces, relative to the load [1].
  double recovered_load_error = unset;
  /// True if statics proves that no equilibrium exists. If this member is false, the status
  /// `no_equilibrium` only means that the solver found no equilibrium.
  bool certain = false;
  [[nodiscard]] bool converged() const { return status == SolveStatus::converged; }
};

}  // namespace raceway::bearing
