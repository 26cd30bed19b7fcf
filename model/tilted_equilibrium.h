#pragma once

#include "bearing/bearing_equilibrium.h"

namespace raceway::model {

/// Equilibrium of a bearing whose inner ring the shaft holds at a tilt about z [rad], under the
/// forces of a point; its moments are found. Newton's method for the two moments that hold it,
/// started from `neighbour`, which may be null.
///
/// Accuracy: tilt to 1e-10 rad.
[[nodiscard]] bearing::BearingEquilibrium solve_tilted(
    const bearing::Bearing& bearing, bearing::OperatingPoint point,
    bearing::EquilibriumOptions options, double tilt,
    const bearing::BearingEquilibrium* neighbour = nullptr);

}  // namespace raceway::model
