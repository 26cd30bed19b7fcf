#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "friction/state.h"

namespace raceway::friction {

/// Load that the load torque of a ball bearing counts [N].
///
///   F_b = max(0.9 F_a cot α0 - 0.1 F_r, F_r)      α0 > 0
///   F_b = max(3.3 F_a - 0.1 F_r, F_r)             α0 = 0
///
/// Deep groove: cot α0 is infinite there; catalogues put 3.3 in place of 0.9 cot α0, its value at
/// the 15 deg or so to which thrust turns the contact angle of such a bearing.
///
/// Source:   [Palmgren1959; Harris2006, vol. 1, ch. 10]; α0 = 0: [KRW2006, p. 116-118].
/// Domain:   every load; F_a and F_r count by magnitude.
template <typename T>
T palmgren_load(const BearingState<T>& s) {
  using std::abs;
  const double angle = s.bearing->geometry().contact_angle;
  const double axial_factor = angle > 0.0 ? 0.9 / std::tan(angle) : 3.3;
  const T thrust = axial_factor * abs(s.axial_load) - 0.1 * s.radial_load;
  // In this order a load that is not a number stays one.
  return thrust < s.radial_load ? s.radial_load : thrust;
}

/// Friction moment of a loaded ball bearing from its load alone [N m].
///
///   M1 = z (F_b/C0)^y F_b d_m
///
/// Source:   [Palmgren1959; CaseStudy, eqs. 20, 21]; [KRW2006, p. 116-118] tabulates z = 0.00067
///           and y = 0.33 for angular contact, other makers z up to 0.001.
/// Domain:   F_b >= 0, zero at zero load; C0 given (require_data() in friction_law.h).
/// Accuracy: the formula to rounding. z of one bearing type differs by half between makers;
///           calibration adjusts it.
struct PalmgrenLoad {
  static constexpr std::string_view id = "palmgren_load";
  static constexpr std::array parameters{
      Parameter{.name = "z", .unit = "1", .initial = 0.001, .lower = 0.0, .upper = 0.02},
      Parameter{.name = "y", .unit = "1", .initial = 0.33, .lower = 0.0, .upper = 1.0}};

  template <typename T>
  static T moment(const BearingState<T>& s, const T& z, const T& y) {
    using std::pow;
    const bearing::BearingGeometry& g = s.bearing->geometry();
    const T load = palmgren_load(s);
    if (load <= 0.0) return T(0.0);  // 0^y has no finite derivatives
    return z * pow(load / g.static_load_rating, y) * load * g.pitch_diameter;
  }
};

/// Friction moment of a bearing that turns in its lubricant, without load [N m].
///
///   M0 = 1e-7 f0 (ν n)^(2/3) d_m³      ν n >= 2000
///   M0 = 160e-7 f0 d_m³                ν n <  2000
///
/// Dimensional as published: M0 [N mm], ν [mm²/s], n [rpm], d_m [mm]; converted here, nowhere else.
/// Source:   [Palmgren1959; CaseStudy, eq. 22]; f0 about 1.3 (grease) to 6.6 (oil jet) for angular
///           contact, by maker [KRW2006, p. 116-118].
/// Domain:   speed >= 0, viscosity > 0. At ν n = 2000 the two lines differ by 0.8 %, as printed;
///           the lower one holds down to standstill, so it is a moment also at zero speed.
/// Accuracy: the formula to rounding. Against tests the formula itself scatters; f0 is what
///           calibration adjusts.
struct PalmgrenViscous {
  static constexpr std::string_view id = "palmgren_viscous";
  static constexpr std::array parameters{
      Parameter{.name = "f0", .unit = "1", .initial = 1.5, .lower = 0.01, .upper = 30.0}};

  template <typename T>
  static T moment(const BearingState<T>& s, const T& f0) {
    using std::pow;
    const T nu_n = (s.kinematic_viscosity / mm2_per_s) * (s.speed / rpm);
    const double d_m = s.bearing->geometry().pitch_diameter / mm;
    // Branched before the power, which has no derivative at standstill.
    const T drag = nu_n < 2000.0 ? T(160.0) : T(pow(nu_n, 2.0 / 3.0));
    return 1e-7 * f0 * drag * (d_m * d_m * d_m * N_mm);
  }
};

}  // namespace raceway::friction
