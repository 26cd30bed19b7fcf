#pragma once

#include "bearing/bearing_equilibrium.h"

namespace raceway::robustness {

/// Looks for an equilibrium by brute force: a grid over the displacements of the inner ring, at
/// each node every ball solved by itself with its contact to the inner race held and with it lost,
/// and from every pattern of contacts that occurs a Newton iteration on all unknowns at once
/// (dense, by difference quotients). Shares the ball's balance with the solver and nothing of its
/// search. Only for loads in the x-y plane. `nodes` is the number of grid lines in each direction.
[[nodiscard]] bool scan_finds_equilibrium(const bearing::Bearing& bearing,
                                          const bearing::OperatingPoint& point,
                                          const bearing::EquilibriumOptions& options, int nodes);

}  // namespace raceway::robustness
