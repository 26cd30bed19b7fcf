#pragma once

#include "tests/hidden_effect/physics.h"

namespace hidden_effect {

/// What the contacts of a thrust loaded bearing take [N mm].
struct ContactMoments {
  double rolling;     ///< resistance of the oil to rolling
  double sliding;     ///< in the ellipses, of film and asperities
  double hysteresis;  ///< of the steel
};

/// Friction summed over the contacts of the balls, from the published formulas alone: Hamrock and
/// Dowson's film with its loss by heat, rolling resistance of a moderately starved inlet after
/// Biboulet and Houpert, Roelands and Eyring in the film, a share of asperities by film over
/// roughness, Houpert's hysteresis. Mineral oil, outer race control, polished races.
///
/// The slip is integrated over strips along rolling and the speed at the centre sought by
/// bracketing; power to 1e-3. Load > 0, speed > 0 [N, rpm]; temperature of the film [C].
[[nodiscard]] ContactMoments contact_moments(const Bearing& bearing, double speed, double load,
                                             double temperature);

}  // namespace hidden_effect
