#pragma once

#include "bearing/ball_equilibrium.h"

namespace raceway::bearing {

/// Where pure thrust puts every ball, to a few digits: the start of all other solves.
struct ThrustStart {
  double axial_displacement = 0.0;  ///< of the inner ring [m]
  Plane ball_centre;                ///< X [m]
};

/// Given the inner contact angle, statics gives both contact loads and the outer angle:
///
///   Qi = (P - Ti cos αi)/sin αi,   tan αo = P / (Qi cos αi - Ti sin αi + 1.4 Fc)   (outer control)
///
/// with P the thrust per ball. What remains is one equation in cot αi, that the radial distances
/// fill the radial distance of the groove centres; it is solved by a bracketing secant.
/// Returns false where that equation has no root: no equilibrium under pure thrust.
[[nodiscard]] bool thrust_start(const BallConstants& constants, Plane free_groove_centre,
                                double thrust_per_ball, ThrustStart& start);

/// Ball and inner groove centre at which one ball under inner control pushes on the inner ring with
/// a given force: tan αi = f_axial / (f_radial + τ), τ = Ti / sin αi, all else from statics.
/// Returns false where the contact would have to pull.
[[nodiscard]] bool ball_under_force(const BallConstants& constants, Plane force,
                                    Plane& groove_centre, Plane& ball_centre);

}  // namespace raceway::bearing
