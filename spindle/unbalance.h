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
  /// Phase lag of the forward whirl behind the unbalance [rad]. The lag is 0 to π if one mode
  /// dominates.
  double lag = unset;
};

/// Returns the orbit of the shaft axis at the position `at` [m] under an unbalance u. The
/// deflections v and w in the planes of y and z are proportional to e^{iΩt}:
///
///   (-Ω² M + (1 + 2 i ζ) K_y) v + i Ω² G w = u Ω²
///   (-Ω² M + (1 + 2 i ζ) K_z) w - i Ω² G v = -i u Ω²
///
/// M, G and K are the mass, gyroscopic and stiffness matrices of shaft and springs. K_y and K_z are
/// the stiffness matrices in the planes of y and z. Ω is the speed, and ζ is the damping ratio.
/// Source:   equations of find_modes(). The loss factor 2 ζ of the stiffness gives each mode the
///           damping ratio ζ at resonance. Tests compare the result for a rigid rotor with
///           |u Ω²/(m (ω0² (1 + 2 i ζ) - Ω²))|, where m is the mass of the rotor and ω0 its
///           natural frequency on the springs.
/// Domain:   speed >= 0, damping_ratio > 0. At standstill, the amplitude is 0 and the lag is NaN.
///           If the equations have no solution, amplitude and lag are NaN.
/// Trap:     damping inside a rotating shaft has no effect on unbalance response, because the bent
///           shape rotates with the shaft. The damping ratio therefore describes the damping of
///           bearings, joints and housing, not of the shaft.
[[nodiscard]] Orbit unbalance_orbit(const Beam& beam, std::span<const Spring> springs, double speed,
                                    const Unbalance& unbalance, double at = 0.0);

}  // namespace raceway::spindle
