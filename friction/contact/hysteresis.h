#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/material.h"

namespace raceway::friction::contact {

/// Rolling moment of one contact due to elastic hysteresis [N m].
///
///   M_h = 7.48e-7 (D/2)^0.33 Q^1.33 (1 - 3.519e-3 (R_z/R_x - 1)^0.8063) (E'_s/E')^(1/3)
///
/// As published, the formula gives M_h in N m for D in m and Q in N. D is the ball diameter and Q
/// the contact load. R_x and R_z are the equivalent radii along and across the rolling direction;
/// E' is the modulus of the contact, E'_s the modulus of steel on steel.
/// Source:   [Houpert2002] as quoted in [Balan2015, eq. 9]. Neither paper was checked. The factor
///           (E'_s/E')^(1/3) is derived. The derivation assumes that the loss is the same fraction
///           of the elastic work for steel and ceramic balls. For steel on steel, the factor is
///           exactly 1.
/// Domain:   Q >= 0, R_z >= R_x. The bracket in the formula is an approximation that falls to zero
///           at R_z/R_x = 1100, which needs a conformity f < 0.5006. Above R_z/R_x = 1100, the
///           function returns zero.
/// Trap:     R_z/R_x is a ratio of radii (25 to 33 at f = 0.52), not the axis ratio of the ellipse
///           (7 to 9).
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

}  // namespace raceway::friction::contact
