#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bearing/material.h"
#include "effects/ball_sum.h"
#include "effects/effect.h"

namespace raceway::effects {

/// Rolling moment of one contact whose steel does not give back all of its deformation [N m].
///
///   M_h = 7.48e-7 (D/2)^0.33 Q^1.33 (1 - 3.519e-3 (R_z/R_x - 1)^0.8063) (E'_s/E')^(1/3)
///
/// Dimensional as published: [N m, m, N]. R_x and R_z are the equivalent radii in and across the
/// rolling direction; E' is the modulus of the contact, E'_s that of steel on steel.
/// Source:   [Houpert2002] as [Balan2015, eq. 9] quotes it; neither print was seen here, the
///           equation of Balan was taken from notes on its text; a public ball screw program has
///           k = R_y/R_x in the same formula. The last factor is derived: a loss in proportion to
///           the elastic work is M_h = (3/16) α Q b, and b goes with (Q R_x/E')^(1/3) at a given
///           shape. So one loss factor α of some per cent serves steel and ceramic balls alike,
///           which is an assumption; the factor is exactly 1 for steel.
/// Domain:   Q >= 0, R_z >= R_x. The bracket is an approximation that falls to zero at R_z/R_x =
///           1100, in grooves of f < 0.5006; none beyond, so that rolling never gains power.
/// Trap:     R_z/R_x is a ratio of radii (25 to 33 at f = 0.52), not that of the ellipse (7 to 9).
[[nodiscard]] inline double hysteresis_moment(double ball_diameter, double load,
                                              double radius_ratio, double contact_modulus) {
  const double shape = 1.0 - 3.519e-3 * std::pow(radius_ratio - 1.0, 0.8063);
  const bearing::Material steel = bearing::steel();
  const double compliance =
      (1.0 - steel.poisson_ratio * steel.poisson_ratio) / steel.elastic_modulus;
  const double steel_modulus = 1.0 / (compliance + compliance);
  return 7.48e-7 * std::pow(0.5 * ball_diameter, 0.33) * std::pow(load, 1.33) *
         std::max(shape, 0.0) * std::cbrt(steel_modulus / contact_modulus);
}

/// Friction moment of the rolling contacts that lose by hysteresis [N m].
///
///   M = c Σ M_h ω_roll/ω       over all contacts, M_h by hysteresis_moment()
///
/// Source:   ω_roll/ω by power, derived.
/// Domain:   converged equilibrium, else NaN. Outer contacts carry the centrifugal force too: only
///           this makes the effect differ from the load moment of the base law.
struct ElasticHysteresis {
  static constexpr std::string_view id = "elastic-hysteresis";
  static constexpr std::string_view title = "hysteresis of the rolling contacts";
  static constexpr std::string_view mechanism =
      "Steel under a rolling ball does not give back all of the work that deformed it. The loss "
      "follows the ball loads, at the outer race with the centrifugal force.";
  static constexpr std::string_view formula =
      "M = c sum of 7.48e-7 (D/2)^0.33 Q^1.33 (1 - 3.519e-3 (R_z/R_x - 1)^0.8063) "
      "(E'_steel/E')^(1/3) w_roll/w, SI; R_x, R_z: equivalent radii along and across rolling";
  static constexpr std::string_view source =
      "[Houpert2002] as quoted by [Balan2015, eq. 9], prints not seen; (E'_steel/E')^(1/3) derived";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "load-exponent",
                                                                 "differential-slip"};
  static constexpr std::array parameters{Parameter{.name = "factor",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 30.0,
                                                   .plausible_lower = 0.3,
                                                   .plausible_upper = 3.0}};
  static constexpr std::array needs{Need::loads, Need::load_levels};
  static constexpr bool needs_equilibrium = true;

  static double unit_moment(const MomentInputs& in) {
    const double diameter = in.state.bearing->geometry().ball_diameter;
    return sum_over_contacts(in.state, [&](const RollingContact& c) {
      return hysteresis_moment(diameter, c.load, c.radius_ratio, c.hertz.contact_modulus) *
             c.rolling_ratio;
    });
  }
};

}  // namespace raceway::effects
