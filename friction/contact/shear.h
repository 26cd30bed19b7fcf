#pragma once

#include <algorithm>
#include <cmath>

#include "friction/contact/roelands.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Shear stress τ at one point of a contact at the sliding speed v, as τ/v and dτ/dv [Pa s/m]. Both
/// values are finite at v = 0. Each shear law has a function at_pressure(p), which returns a
/// function object for the pressure p. The function object returns the ShearResponse for an
/// argument v².
struct ShearResponse {
  double secant;   ///< τ/v [Pa s/m]
  double tangent;  ///< dτ/dv [Pa s/m], between 0 and τ/v
};

/// Shear stress of an oil film with asperities that carry a share of the load [Pa].
///
///   τ = (1 - φ) min(τ0 asinh(η(p) v/(h_c τ0)), Γ p) + φ μ p v/sqrt(v² + ε²)
///
/// p is the pressure, v the sliding speed and h_c the central film thickness. τ0 is Eyring's
/// stress, Γ the limiting traction, φ the result of asperity_share(), and μ the boundary friction
/// coefficient. The small speed ε is 1e-6 of the mean surface speed, far below any relevant slip. ε
/// makes τ a smooth function of the slip where the slip changes sign.
/// Source:   Eyring's law with a limiting stress, as in textbooks [Hamrock1994], not checked
///           against the book. η(p) is Roelands' law.
/// Domain:   v >= 0, p >= 0, h_c > 0; at φ = 1 (standstill), the film has no effect.
/// Accuracy: the stress of a film is accurate to 30 % at pressures below 1 GPa. In bearings with a
///           full film, this stress causes only about 2 % of the friction, and the rolling
///           resistance of the oil about 98 %.
struct FilmShear {
  Roelands viscosity;
  double film;               ///< h_c [m]
  double eyring_stress;      ///< τ0 [Pa]
  double limiting_traction;  ///< Γ [1]
  double asperity_share;     ///< φ [1]
  double boundary_friction;  ///< μ [1]
  double small_speed;        ///< ε [m/s]

  /// Upper limit of η(p)/(h_c τ0) [s/m]. Without this limit, the viscosity would become infinite at
  /// unrealistic pressures.
  static constexpr double glass = 1e30;

  struct Point {
    double film_share, eyring_stress, steepness, limit, boundary, small_speed2;

    [[nodiscard]] ShearResponse operator()(double speed2) const {
      const double root = speed2 + small_speed2;
      const double edge = root > 0.0 ? boundary / std::sqrt(root) : 0.0;
      ShearResponse r{edge, edge * (root > 0.0 ? small_speed2 / root : 0.0)};
      if (!(film_share > 0.0)) return r;
      const double speed = std::sqrt(speed2);
      const double x = steepness * speed;
      if (x < 1e-4) {  // asinh(x)/x = 1 - x²/6 + ..., to rounding
        const double newton = film_share * eyring_stress * steepness;
        r.secant += newton * (1.0 - x * x / 6.0);
        r.tangent += newton * (1.0 - x * x / 2.0);
        return r;
      }
      const double length = std::sqrt(1.0 + x * x);
      const double stress = eyring_stress * std::log(x + length);
      const bool limited = stress > limit;
      r.secant += film_share * (limited ? limit : stress) / speed;
      r.tangent += limited ? 0.0 : film_share * eyring_stress * steepness / length;
      return r;
    }
  };

  [[nodiscard]] Point at_pressure(double pressure) const {
    const bool any_film = asperity_share < 1.0 && film > 0.0;
    return {
        .film_share = any_film ? 1.0 - asperity_share : 0.0,
        .eyring_stress = eyring_stress,
        .steepness = any_film ? std::min(viscosity(pressure) / (film * eyring_stress), glass) : 0.0,
        .limit = limiting_traction * pressure,
        .boundary = asperity_share * boundary_friction * pressure,
        .small_speed2 = small_speed * small_speed};
  }
};

/// Dry friction, τ = μ p v/sqrt(v² + ε²): equal to FilmShear at φ = 1. Tests use this law,
/// because it gives the traction of a contact in closed form for simple slip fields.
struct CoulombShear {
  double friction_coefficient;  ///< μ [1]
  double small_speed;           ///< ε [m/s], > 0

  struct Point {
    double stress, small_speed2;
    [[nodiscard]] ShearResponse operator()(double speed2) const {
      const double root = speed2 + small_speed2;
      const double secant = stress / std::sqrt(root);
      return {secant, secant * small_speed2 / root};
    }
  };
  [[nodiscard]] Point at_pressure(double pressure) const {
    return {friction_coefficient * pressure, small_speed * small_speed};
  }
};

/// A film of constant viscosity, τ = η v/h: the limit of FilmShear at φ = 0 and small v. Tests use
/// this law, because it gives the traction of a contact in closed form for simple slip fields.
struct NewtonShear {
  double viscosity;  ///< η [Pa s]
  double film;       ///< film thickness h [m]

  struct Point {
    double slope;
    [[nodiscard]] ShearResponse operator()(double) const { return {slope, slope}; }
  };
  [[nodiscard]] Point at_pressure(double) const { return {viscosity / film}; }
};

}  // namespace raceway::friction::contact
