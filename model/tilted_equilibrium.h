#pragma once

#include "model/balance.h"

namespace raceway::model {

/// Moments that hold a bearing at a tilt [N m].
struct HoldingMoments {
  double y = unset, z = unset;
};

/// Balance of a bearing as solve_balls() has it, whose inner ring the shaft holds at a tilt about z
/// [rad], under the forces of a point; its moments are found. Newton's method for the two moments
/// that hold it, started from `neighbour`, which may be null, and the moments that hold that one
/// where they are known. `moments` are those found.
///
/// Accuracy: tilt to 1e-10 rad.
[[nodiscard]] bearing::BearingEquilibrium solve_tilted(const Model& model,
                                                       const bearing::Bearing& bearing,
                                                       bearing::OperatingPoint point, double tilt,
                                                       const friction::Lubricant& oil,
                                                       const bearing::BearingEquilibrium* neighbour,
                                                       HoldingMoments& moments);

}  // namespace raceway::model
