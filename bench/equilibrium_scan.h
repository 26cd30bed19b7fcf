#pragma once

#include "bearing/bearing_equilibrium.h"

namespace raceway::robustness {

/// Returns true if a search on a grid of inner ring displacements finds an equilibrium. At each
/// node, every ball is solved separately, once with a preference for the contact with the inner
/// race and once with a preference for the lost contact. Each pattern of contacts that occurs is
/// the start of a Newton iteration for all unknowns, with difference quotients as derivatives. The
/// function uses ball_balance() of the solver, but not its search. The loads must be in the x-y
/// plane. `nodes` is the number of grid lines in each direction.
[[nodiscard]] bool scan_finds_equilibrium(const bearing::Bearing& bearing,
                                          const bearing::OperatingPoint& point,
                                          const bearing::EquilibriumOptions& options, int nodes);

}  // namespace raceway::robustness
