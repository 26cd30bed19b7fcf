#pragma once

#include <span>

#include "spindle/beam.h"

namespace raceway::spindle {

/// An eccentric mass that rotates with the shaft.
struct Unbalance {
  double size = unset;           ///< mass times its radius [kg m]
  double position = unset;       ///< distance behind the nose face [m]
  double damping_ratio = unset;  ///< damping ratio of every mode [1]
};

/// Path of a point of the axis during one revolution.
struct Orbit {
  double amplitude = unset;  ///< largest distance from the position without unbalance [m]
  /// Phase lag of the forward part behind the unbalance, 0 to π if other modes are far [rad].
  double lag = unset;
};

/// Returns the path of the axis at `at` [m] under an unbalance u, for both planes with q e^{iΩt}:
///
///   (-Ω² M + (1 + 2 i ζ) K_y) v + i Ω² G w = u Ω²
///   (-Ω² M + (1 + 2 i ζ) K_z) w - i Ω² G v = -i u Ω²
///
/// Source:   equations of find_modes(). The loss factor 2 ζ of the whole stiffness gives each mode
///           the damping ratio ζ at resonance. A rigid rotor on springs has u Ω²/(m (ω0² (1 + 2 i
///           ζ) - Ω²)) (tested).
/// Domain:   speed >= 0, damping_ratio > 0. At rest, the result is a point without a lag.
/// Trap:     damping inside a rotating shaft has no effect on unbalance response, because the bent
///           shape rotates with the shaft. The ratio therefore describes bearings, joints and
///           housing; it is not a property of the shaft.
[[nodiscard]] Orbit unbalance_orbit(const Beam& beam, std::span<const Spring> springs, double speed,
                                    const Unbalance& unbalance, double at = 0.0);

}  // namespace raceway::spindle
