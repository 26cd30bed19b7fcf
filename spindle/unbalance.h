#pragma once

#include <span>

#include "spindle/beam.h"

namespace raceway::spindle {

/// A mass out of the axis that turns with the shaft.
struct Unbalance {
  double size = unset;           ///< mass times its radius [kg m]
  double position = unset;       ///< behind the nose face [m]
  double damping_ratio = unset;  ///< of every mode [1]
};

/// Path of a point of the axis, once around in a turn.
struct Orbit {
  double amplitude = unset;  ///< largest distance from where it stands without unbalance [m]
  /// Lag of the part that runs with the rotation behind the unbalance, 0 to π where modes are far
  /// [rad].
  double lag = unset;
};

/// Path of the axis at `at` [m] under an unbalance u, in both planes with q e^{iΩt}:
///
///   (-Ω² M + (1 + 2 i ζ) K_y) v + i Ω² G w = u Ω²
///   (-Ω² M + (1 + 2 i ζ) K_z) w - i Ω² G v = -i u Ω²
///
/// Source:   equations of find_modes(); the loss factor 2 ζ of the whole stiffness gives each mode
///           the ratio ζ where it is met. A rigid rotor on springs has u Ω²/(m (ω0² (1 + 2 i ζ) -
///           Ω²)) (tested).
/// Domain:   speed >= 0, damping_ratio > 0; at rest a point without a lag.
/// Trap:     damping within a turning shaft does nothing against unbalance, which bends it once and
///           for all: the ratio stands for bearings, joints and housing, and is no property of the
///           shaft.
[[nodiscard]] Orbit unbalance_orbit(const Beam& beam, std::span<const Spring> springs, double speed,
                                    const Unbalance& unbalance, double at = 0.0);

}  // namespace raceway::spindle
