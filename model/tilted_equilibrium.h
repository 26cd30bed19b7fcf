#pragma once

#include "model/balance.h"

namespace raceway::model {

/// Balance of a bearing as solve_balls() has it, whose inner ring the shaft holds at a tilt about z
/// [rad], under the forces of a point; its moments are found. Newton's method for the two moments
/// that hold it, started from `neighbour`, which may be null.
///
/// Accuracy: tilt to 1e-10 rad.
[[nodiscard]] bearing::BearingEquilibrium solve_tilted(
    const Model& model, const bearing::Bearing& bearing, bearing::OperatingPoint point, double tilt,
    const friction::Lubricant& oil, const bearing::BearingEquilibrium* neighbour = nullptr);

}  // namespace raceway::model
