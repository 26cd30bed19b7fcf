#pragma once

#include "bearing/bearing.h"

namespace raceway::bearing {

/// Returns the thrust on the relieved bearing of two equal bearings with rigid preload [N]; 0 if
/// the relieved bearing has lost its load.
///
///   δ(F2 + F_a, n) + δ(F2, n) = 2 δ(P, 0)
///
/// δ(F, n) is the axial displacement of the inner ring under a pure thrust F at the speed n, with
/// outer race control. The load F_a moves both inner rings by the same distance. Centrifugal forces
/// push the balls outwards, so the thrust is higher at speed than at standstill.
///
/// F2 is the result, P > 0 is `preload`, the preload force at standstill, F_a >= 0 is `load`, the
/// external axial load [N], and n is `speed` [rad/s]. All rings have the same temperature. The
/// displacements come from thrust_start.h, so the error of the result is at most 1e-3 of the
/// preload. The result is NaN if a bearing has no equilibrium.
[[nodiscard]] double relieved_thrust(const Bearing& bearing, double preload, double load,
                                     double speed);

}  // namespace raceway::bearing
