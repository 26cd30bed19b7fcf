#pragma once

#include <span>

#include "spindle/beam.h"

namespace raceway::spindle {

/// An eccentric mass that rotates with the shaft.
struct Unbalance {
  double size = unset;           ///< unbalance u, mass times radius [kg m]
  double position = unset;       ///< distance behind the nose face [m]
  double damping_ratio = unset;  ///< damping ratio of every mode [1]
};

/// Orbit of a point on the shaft axis during one revolution.
struct Orbit {
  double amplitude = unset;  ///< largest distance from the position without unbalance [m]
  /// Phase lag of the forward whirl behind the unbalance [rad]. If one mode dominates, the lag is
  /// between 0 and π.
  double lag = unset;
};

/// Returns the orbit of the shaft axis at the position `at` [m] under an unbalance u. The
/// deflections v and w in the planes of y and z are proportional to e^{iΩt}:
///
///   (-Ω² M + (1 + 2 i ζ) K_y) v + i Ω² G w = u Ω²
///   (-Ω² M + (1 + 2 i ζ) K_z) w - i Ω² G v = -i u Ω²
///
/// M and G are the mass and gyroscopic matrices of the shaft. K_y and K_z are the stiffness
/// matrices of shaft and springs in the planes of y and z. Ω is the speed, and ζ is the damping
/// ratio.
/// Source:   equations of motion as in find_modes(). The factor 1 + 2 i ζ of the stiffness (loss
///           factor 2 ζ) gives each mode the damping ratio ζ at resonance. For a rigid rotor with
///           the mass m and the natural frequency ω0 on its springs, the amplitude is |u Ω²/(m (ω0²
///           (1 + 2 i ζ) - Ω²))| (tested).
/// Domain:   speed >= 0, damping_ratio > 0. At standstill, the amplitude is 0 and the lag is NaN.
///           If the equations have no solution, amplitude and lag are NaN.
/// Trap:     damping inside a rotating shaft has no effect on unbalance response, because the bent
///           shape rotates with the shaft. The damping ratio therefore describes the damping of
///           bearings, joints and housing, not of the shaft.
[[nodiscard]] Orbit unbalance_orbit(const Beam& beam, std::span<const Spring> springs, double speed,
                                    const Unbalance& unbalance, double at = 0.0);

}  // namespace raceway::spindle
