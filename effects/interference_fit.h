#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Radial growth of the inner raceway from an interference fit on the shaft [m].
///
///   u = (d/d_i) I/2,   I = max(I0 - (3 + ν) ρ ω² d d_i²/(16 E), 0)
///
/// I0 is the interference at standstill, and I the interference at the speed ω. d is the bore, and
/// d_i = d_m - D cos α0 the diameter of the inner raceway (d_m: pitch diameter, D: ball diameter,
/// α0: free contact angle). ν, ρ and E are Poisson's ratio, density and elastic modulus of the
/// rings. The growth u changes the free contact angle: cos α0 becomes cos α0 + u/A, where A is the
/// distance between the groove centres. If α0 = 0, the radial clearance decreases by 2 u.
/// Source:   derived from Lamé's equations for a ring of rectangular section on a solid shaft of
///           the same material. The second term of I is the growth of the bore relative to the
///           shaft at speed. The centrifugal growth of the raceway is a separate effect.
/// Domain:   speed >= 0. At the speed at which the ring becomes loose (I = 0), the derivative of u
///           with respect to ω is discontinuous.
///
/// For the bearing sets of a shaft, the fit acts from the mounting on, before the shaft turns. A
/// preload given as a force already includes the fit, so only the loss of interference at speed
/// changes the equilibrium of the sets. A preload given as an offset or a class refers to bearings
/// before mounting, so the fit increases the preload.
struct InterferenceFit {
  static constexpr std::string_view id = "interference-fit";
  static constexpr std::string_view title = "inner ring expanded by its fit";
  static constexpr std::string_view mechanism =
      "The interference fit expands the inner ring and reduces the clearance. Centrifugal "
      "force loosens the fit at high speed, so the expansion falls.";
  static constexpr std::string_view formula =
      "u = (d/d_i) I/2, I = I0 - (3 + nu) rho w^2 d d_i^2/(16 E), not below zero (u: growth "
      "of the raceway radius, d: bore, d_i: raceway diameter, I0: interference at "
      "standstill, w: shaft speed, nu: Poisson's ratio of the rings, rho: density, E: "
      "elastic modulus)";
  static constexpr std::string_view source = "Lame's equations of thick rings, derived";
  static constexpr std::array<std::string_view, 3> confused_with{
      "load-offset", "thermal-ring-growth", "centrifugal-ring-growth"};
  static constexpr std::array parameters{Parameter{.name = "interference_um",
                                                   .unit = "um",
                                                   .initial = 5.0,
                                                   .lower = 0.0,
                                                   .upper = 25.0,
                                                   .plausible_lower = 1.0,
                                                   .plausible_upper = 15.0}};
  static constexpr std::array needs{Need::loads, Need::ball_load_law};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    const bearing::BearingGeometry& g = in.bearing.geometry();
    const bearing::Material& m = in.bearing.rings();
    const double raceway = g.pitch_diameter - g.ball_diameter * std::cos(g.contact_angle);
    const double loosening = (3.0 + m.poisson_ratio) * m.density * in.point.speed * in.point.speed *
                             g.bore * raceway * raceway / (16.0 * m.elastic_modulus);
    const double interference = std::max(values[0] * um - loosening, 0.0);
    c.radial_growth += 0.5 * interference * g.bore / raceway;
  }
};

}  // namespace raceway::effects
