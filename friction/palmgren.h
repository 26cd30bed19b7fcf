#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "friction/state.h"
#include "friction/viscous_drag.h"

namespace raceway::friction {

/// Load F_b in Palmgren's load moment of a ball bearing [N].
///
///   F_b = max(0.9 F_a cot α0 - 0.1 F_r, F_r)      α0 > 0
///   F_b = max(3.3 F_a - 0.1 F_r, F_r)             α0 = 0
///
/// F_a and F_r are the axial and the radial load, and α0 is the nominal contact angle. For a
/// deep-groove bearing (α0 = 0), cot α0 is infinite, and catalogues use 3.3 instead of 0.9 cot α0.
/// The value 3.3 corresponds to a contact angle of about 15 deg, as in a deep-groove bearing under
/// thrust.
///
/// Source:   [Palmgren1959; Harris2006, vol. 1, ch. 10]; α0 = 0: [KRW2006, p. 116-118].
/// Domain:   any load; the sign of F_a has no effect.
template <typename T>
T palmgren_load(const BearingState<T>& s) {
  using std::abs;
  const double angle = s.bearing->geometry().contact_angle;
  const double axial_factor = angle > 0.0 ? 0.9 / std::tan(angle) : 3.3;
  const T thrust = axial_factor * abs(s.axial_load) - 0.1 * s.radial_load;
  // With the operands in this order, the result is NaN if a load is NaN.
  return thrust < s.radial_load ? s.radial_load : thrust;
}

/// Factors of the static equivalent load [1].
struct StaticLoadFactors {
  double X0, Y0;
};

/// Static load factors of a single row bearing with contact angle α0 [1].
///
///   X0 = 0.5,  Y0 = 0.46  0.42  0.38  0.33  0.29  0.26  0.22       0 < α0
///    at α0 =         15    20    25    30    35    40    45 deg, linear between, constant outside
///   X0 = 0.6,  Y0 = 0.5                                           α0 = 0, deep groove
///
/// Source: [ISO76], not checked against the standard; bearing manufacturers publish the same
///         values.
[[nodiscard]] inline StaticLoadFactors static_load_factors(double contact_angle) {
  static constexpr std::array Y0{0.46, 0.42, 0.38, 0.33, 0.29, 0.26, 0.22};
  constexpr double first = 15.0 * degree, per_step = 1.0 / (5.0 * degree);
  if (contact_angle <= 0.0) return {0.6, 0.5};
  const double at = std::clamp((contact_angle - first) * per_step, 0.0, Y0.size() - 1.0);
  const auto k = std::min(static_cast<std::size_t>(static_cast<int>(at)), Y0.size() - 2);
  return {0.5, Y0[k] + (at - static_cast<double>(k)) * (Y0[k + 1] - Y0[k])};
}

/// Static equivalent load [N].
///
///   P0 = max(X0 F_r + Y0 F_a, F_r)
///
/// X0 and Y0 are static_load_factors(). Source: [ISO76]. Domain: any load; the sign of F_a has no
/// effect.
template <typename T>
T static_equivalent_load(const BearingState<T>& s) {
  using std::abs;
  const auto [X0, Y0] = static_load_factors(s.bearing->geometry().contact_angle);
  const T combined = X0 * s.radial_load + Y0 * abs(s.axial_load);
  // With the operands in this order, the result is NaN if a load is NaN.
  return combined < s.radial_load ? s.radial_load : combined;
}

/// Load in the formula of the factor f1 [N]: P0 or F_b, as selected by BearingState::f1_load.
template <typename T>
T f1_load(const BearingState<T>& s) {
  return s.f1_load == F1Load::P0 ? static_equivalent_load(s) : palmgren_load(s);
}

/// Typical load of a spindle bearing [N]: 1000 N for F_b, or 200 N for P0. Both values result from
/// a thrust of about 520 N at a contact angle of 25 deg. Friction laws with a fitted load exponent
/// use the typical load as reference load.
[[nodiscard]] constexpr double medium_load(F1Load load) {
  return load == F1Load::P0 ? 200.0 : 1000.0;
}

/// Load ratio in the power law of f1 [1]: P0/C0 or F_b/C0.
template <typename T>
T f1_ratio(const BearingState<T>& s) {
  const double C0 = s.bearing->geometry().static_load_rating;
  if (s.f1_load == F1Load::F_b) return palmgren_load(s) / C0;
  // A product with the reciprocal, as in automatic differentiation: the value has the same digits
  // with and without derivatives.
  return static_equivalent_load(s) * (1.0 / C0);
}

/// Load-dependent friction moment of a ball bearing [N m].
///
///   M1 = f1 F_b d_m,   f1 = z (P0/C0)^y
///
/// F_b is palmgren_load(), P0 is static_equivalent_load(), d_m is the pitch diameter, and C0 the
/// static load rating. If BearingState::f1_load is F_b, f1 = z (F_b/C0)^y. For equal z and under
/// pure thrust, the moment with F_b is larger than with P0, by a factor of 1.7 at a contact angle
/// of 25 deg and 1.9 at 15 deg. A value of z for P0 is not valid for F_b.
/// Source:   [Palmgren1959; Harris2006, vol. 1, ch. 10], not checked against the books. The formula
///           f1 = z (P0/C0)^y is in [KRW2006, p. 116-118], with z = 0.00067 and y = 0.33 for
///           angular contact. Some manufacturers give values of z up to 0.001. The formula f1 = z
///           (F_b/C0)^y is in [CaseStudy, eqs. 20, 21].
/// Domain:   F_b >= 0; the moment is zero at zero load. C0 must be given (require_data() in
///           friction_law.h).
/// Accuracy: the code agrees with the formula to rounding error. For one bearing type, z differs by
///           up to 50 % between manufacturers; calibration fits z.
struct PalmgrenLoad {
  static constexpr std::string_view id = "palmgren_load";
  static constexpr std::array parameters{
      Parameter{.name = "z",
                .unit = "1",
                .initial = 0.001,
                .lower = 0.0,
                .upper = 0.02,
                .plausible_lower = 0.00067,
                .plausible_upper = 0.001},
      Parameter{.name = "y", .unit = "1", .initial = 0.33, .lower = 0.0, .upper = 1.0}};
  static constexpr std::array<std::string_view, 3> bearing_data{"contact_angle", "pitch_diameter",
                                                                "static_load_rating"};

  template <typename T>
  static T moment(const BearingState<T>& s, const T& z, const T& y) {
    using std::pow;
    const T load = palmgren_load(s);
    if (load <= 0.0) return T(0.0);  // 0^y has no finite derivatives
    return z * pow(f1_ratio(s), y) * load * s.bearing->geometry().pitch_diameter;
  }
};

/// Viscous moment of a ball bearing by palmgren_viscous_moment() [N m].
///
/// Source:   f0 from about 1.3 (grease) to 6.6 (oil jet) for angular contact, depending on the
///           manufacturer [KRW2006, p. 116-118].
/// Accuracy: the code agrees with the formula to rounding error. Measured moments scatter about the
///           formula; calibration fits f0.
struct PalmgrenViscous {
  static constexpr std::string_view id = "palmgren_viscous";
  static constexpr std::array parameters{Parameter{.name = "f0",
                                                   .unit = "1",
                                                   .initial = 1.5,
                                                   .lower = 0.01,
                                                   .upper = 30.0,
                                                   .plausible_lower = 1.3,
                                                   .plausible_upper = 6.6}};
  static constexpr std::array<std::string_view, 1> bearing_data{"pitch_diameter"};

  template <typename T>
  static T moment(const BearingState<T>& s, const T& f0) {
    return palmgren_viscous_moment(f0, s.kinematic_viscosity, s.speed, s.pitch_diameter());
  }
};

}  // namespace raceway::friction
