#pragma once

#include "model/balance.h"

namespace raceway::model {

/// Moments that keep a bearing at a given tilt [N m].
struct HoldingMoments {
  double y = unset, z = unset;
};

/// Solves the equilibrium of a bearing like solve_balls(), under the forces of a point. The shaft
/// holds the inner ring at a tilt about z [rad]. Newton's method solves for the two moments that
/// this tilt needs. The method starts from `neighbour`, which may be null, and from the moments of
/// the neighbour in `moments`, unless they are NaN. The function then replaces `moments` by the
/// solved moments, or by NaN if the solve fails.
///
/// Accuracy: tilt to 1e-10 rad.
[[nodiscard]] bearing::BearingEquilibrium solve_tilted(const Model& model,
                                                       const bearing::Bearing& bearing,
                                                       bearing::OperatingPoint point, double tilt,
                                                       const friction::Lubricant& oil,
                                                       const bearing::BearingEquilibrium* neighbour,
                                                       HoldingMoments& moments);

}  // namespace raceway::model
