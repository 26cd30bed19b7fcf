#pragma once

#include "bearing/bearing.h"

namespace raceway::bearing {

/// Returns the axial load F2 of the relieved bearing in a pair of equal bearings with rigid preload
/// [N]. An external axial load F_a increases the load of one bearing and relieves the other
/// bearing. F2 is 0 if F_a unloads the relieved bearing completely.
///
///   δ(F2 + F_a, n) + δ(F2, n) = 2 δ(P, 0)
///
/// δ(F, n) is the axial displacement of the inner ring under a pure axial load F at the speed n,
/// with outer race control. F_a moves both inner rings by the same distance. Centrifugal forces
/// push the balls outwards, so F2 is higher at speed than at standstill.
///
/// P > 0 is `preload`, the preload force at standstill [N]. F_a >= 0 is `load` [N], and n is
/// `speed` [rad/s]. All rings have the same temperature. The displacements come from the
/// approximation in thrust_start.h, so the error of the result is at most 1e-3 of the preload. The
/// result is NaN if a bearing has no equilibrium.
[[nodiscard]] double relieved_thrust(const Bearing& bearing, double preload, double load,
                                     double speed);

}  // namespace raceway::bearing
