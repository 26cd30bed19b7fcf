#pragma once

#include <array>
#include <cmath>

#include "friction/palmgren.h"

namespace raceway::friction {

/// Viscous moment of the law `powers` [N m]: Palmgren's viscous moment with fitted exponents.
///
///   M0 = 1e-7 f0 300000^(2/3) (max(ν n, 2000)/300000)^a (P/P_m)^b d_m³
///
/// ν n is in mm²/s rpm and d_m in mm, as in palmgren_viscous_moment(). a and b are the fitted
/// exponents. P is the load P0 or F_b (f1_load()), and P_m a typical value of this load
/// (medium_load()). With a = 2/3 and b = 0, the moment equals Palmgren's viscous moment for ν n >=
/// 2000. The reference values 300 000 and P_m make f0 nearly independent of the exponents in a fit.
/// PalmgrenLoad is the load moment of the law. Its load exponent y is fitted too.
///
/// Source:   rolling moments of the form (ν n)^0.6 F^0.54 [SKFGeneral] and U^0.66 W^0.47, with
///           dimensionless speed U and load W [BibouletHoupert2010]. There are no published
///           exponents for a whole bearing, so a fit finds them.
/// Domain:   the speeds, loads and temperatures of the fitted measurements. The moment is zero
///           without load.
/// Accuracy: as accurate as the fit within the measured range; unknown outside this range.
struct PowersViscous {
  static constexpr std::array parameters{Parameter{.name = "viscous_exponent",
                                                   .unit = "1",
                                                   .initial = 0.667,  // Palmgren: 2/3
                                                   .lower = 0.2,
                                                   .upper = 1.2},
                                         Parameter{.name = "viscous_load_exponent",
                                                   .unit = "1",
                                                   .initial = 0.0,
                                                   .lower = -0.3,
                                                   .upper = 1.0}};

  template <typename T>
  static T moment(const BearingState<T>& s, const T& f0, const T& exponent,
                  const T& load_exponent) {
    using std::pow;
    const T load = f1_load(s);
    if (load <= 0.0) return T(0.0);  // 0^b has no finite derivatives
    const T nu_n = (s.kinematic_viscosity / mm2_per_s) * (s.speed / rpm);
    // A product with the reciprocal, as in automatic differentiation: the value has the same digits
    // with and without derivatives.
    const T share = (nu_n < 2000.0 ? T(2000.0) : nu_n) * (1.0 / medium_nu_n);
    // Palmgren's moment at ν n = 300 000. It depends on ν and n only through the product ν n.
    const T medium =
        palmgren_viscous_moment(f0, T(medium_nu_n * mm2_per_s), T(1.0 * rpm), s.pitch_diameter());
    return medium * pow(share, exponent) *
           pow(load * (1.0 / medium_load(s.f1_load)), load_exponent);
  }
};

/// Law `contact-powers`: the law `powers` with the loads of the ball contacts [N m].
///
///   M = 1/(2 Z) Σ M_p(Z Q sin α0)
///
/// The formula applies to the load moment and to the viscous moment. The sum is over the inner and
/// outer contacts of all Z balls. Q is the load of a contact. M_p(F_a) is the moment of the law
/// `powers` under the thrust F_a alone. At low speed, the contact angles are near α0. M is then
/// nearly M_p(F_a) under pure thrust F_a. At high speed, the centrifugal force increases the loads
/// of the outer contacts. If α0 = 0, the formula uses 15 deg instead of α0, like palmgren_load().
///
/// Source:   derived. The rolling moment of one contact is a product of powers of speed and load
///           [BibouletHoupert2010].
/// Domain:   as PowersViscous; the balls must be in equilibrium.
/// Accuracy: as PowersViscous.
struct ContactPowers {
  /// Contact angle in the formula [rad]: α0, or 15 deg if α0 = 0.
  static double angle_of_thrust(const bearing::Bearing& bearing) {
    const double angle = bearing.geometry().contact_angle;
    return angle > 0.0 ? angle : 15.0 * degree;
  }
};

}  // namespace raceway::friction
