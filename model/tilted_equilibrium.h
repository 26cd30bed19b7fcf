#pragma once

#include "model/balance.h"

namespace raceway::model {

/// Moments that keep a bearing at a given tilt [N m].
struct HoldingMoments {
  double y = unset, z = unset;
};

/// Solves the equilibrium of a bearing like solve_balls(), under the forces of the operating point.
/// The shaft holds the inner ring at the angle `tilt` about z [rad]. Newton's method computes the
/// moments about the two radial axes that hold this tilt. The iteration starts from `neighbour`, a
/// known solution for a similar tilt, and from `moments`, which contains the moments of this
/// solution. Without a known solution, pass null as `neighbour` and NaN as moments. On return,
/// `moments` contains the computed moments, or NaN if the method did not converge.
///
/// Accuracy: the computed tilt differs from `tilt` by less than 1e-10 rad.
[[nodiscard]] bearing::BearingEquilibrium solve_tilted(const Model& model,
                                                       const bearing::Bearing& bearing,
                                                       bearing::OperatingPoint point, double tilt,
                                                       const friction::Lubricant& oil,
                                                       const bearing::BearingEquilibrium* neighbour,
                                                       HoldingMoments& moments);

}  // namespace raceway::model
