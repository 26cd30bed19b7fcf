#pragma once

#include <string_view>

#include "record/units.h"

namespace raceway::bearing {

enum class SolveStatus {
  not_run,
  converged,
  no_equilibrium,   ///< no balance was found; SolveReport::certain says where there is none
  iteration_limit,  ///< ended by EquilibriumOptions::max_iterations
  singular,         ///< the load leaves a displacement undetermined
  not_finite,       ///< the numbers left the range of doubles
};

/// The status in the words of the JSON results, e.g. "no_equilibrium".
[[nodiscard]] std::string_view name(SolveStatus status);

/// Outcome of a solve. It starts as a failure; only the solver turns it into a success.
struct SolveReport {
  SolveStatus status = SolveStatus::not_run;
  int iterations = 0;       ///< Newton steps, over all stages
  double residual = unset;  ///< largest imbalance of ring and balls, scaled by load [1]
  double recovered_load_error =
      unset;  ///< loads summed again from the reported balls, relative [1]
  /// True where statics alone proves that no balance exists. With false, `no_equilibrium` only says
  /// that the search found none.
  bool certain = false;
  [[nodiscard]] bool converged() const { return status == SolveStatus::converged; }
};

}  // namespace raceway::bearing
