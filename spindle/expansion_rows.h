#pragma once

#include "spindle/heat_paths.h"
#include "spindle/layout.h"

namespace raceway::spindle {

/// Length of a body between two planes as a weighted sum of its cells' temperatures,
///
///   u = ∫ α ΔT dz = sum w_k (T_k - T0),
///
/// with the mean of α ΔT over a cross-section weighted by E A: sections stay plane. [m/K]
/// Domain: lines of the grid at both planes; zero beyond the body.
[[nodiscard]] Vector expansion_row(const Mesh& mesh, Body body, double from, double to,
                                   Eigen::Index nodes);

}  // namespace raceway::spindle
