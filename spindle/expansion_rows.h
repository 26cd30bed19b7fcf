#pragma once

#include "spindle/heat_paths.h"
#include "spindle/layout.h"

namespace raceway::spindle {

/// Returns the weights w_k [m/K] of the cell temperatures in the elongation of a body between two
/// planes,
///
///   u = ∫ α ΔT dz = sum w_k (T_k - T0),
///
/// The mean of α ΔT over a cross-section is weighted by E A, because plane sections remain plane.
/// Domain: both planes are lines of the grid; weights outside the body are zero.
[[nodiscard]] Vector expansion_row(const Mesh& mesh, Body body, double from, double to,
                                   Eigen::Index nodes);

}  // namespace raceway::spindle
