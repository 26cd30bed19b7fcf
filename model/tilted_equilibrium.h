#pragma once

#include "model/balance.h"

namespace raceway::model {

/// Moments that keep a bearing at a given tilt [N m].
struct HoldingMoments {
  double y = unset, z = unset;
};

/// Solves the equilibrium of a bearing like solve_balls(), with an inner ring that the shaft keeps
/// at a tilt about z [rad], under the forces of a point. The moments are found. Newton's method
/// solves for the two moments. It starts from `neighbour`, which may be null, and from its moments,
/// if they are known. `moments` receives the result.
///
/// Accuracy: tilt to 1e-10 rad.
[[nodiscard]] bearing::BearingEquilibrium solve_tilted(const Model& model,
                                                       const bearing::Bearing& bearing,
                                                       bearing::OperatingPoint point, double tilt,
                                                       const friction::Lubricant& oil,
                                                       const bearing::BearingEquilibrium* neighbour,
                                                       HoldingMoments& moments);

}  // namespace raceway::model
