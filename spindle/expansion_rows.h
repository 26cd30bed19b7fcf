#pragma once

#include "spindle/heat_paths.h"
#include "spindle/layout.h"

namespace raceway::spindle {

/// Returns the weights w_k of the cell temperatures T_k in the elongation of a body between the
/// axial positions `from` and `to` [m/K]:
///
///   u = ∫ α ΔT dz = sum w_k (T_k - T0)
///
/// α is the thermal expansion coefficient, ΔT the temperature rise, z the axial position, and T0
/// the mounting temperature. The mean of α ΔT over a cross-section is weighted by the elastic
/// modulus times the area, because plane sections remain plane. The result has `nodes` elements.
/// Domain: both positions are grid lines of the mesh. Cells outside the body or outside the two
///         positions have the weight 0. If `to` < `from`, the weights of the cells between the two
///         positions are negative.
[[nodiscard]] Vector expansion_row(const Mesh& mesh, Body body, double from, double to,
                                   Eigen::Index nodes);

}  // namespace raceway::spindle
