#pragma once

#include <cmath>

#include "record/units.h"

namespace raceway::friction {

/// Typical product ν n of kinematic viscosity and speed of a spindle bearing [mm²/s rpm]. Friction
/// laws with a fitted exponent of ν n use this product as reference value.
inline constexpr double medium_nu_n = 300000.0;

/// Friction moment of a bearing that rotates in its lubricant without load [N m].
///
///   M0 = 1e-7 f0 (ν n)^(2/3) d_m³      ν n >= 2000
///   M0 = 160e-7 f0 d_m³                ν n <  2000
///
/// ν is the kinematic viscosity, n the speed and d_m the pitch diameter. The formulas are in their
/// published units: M0 [N mm], ν [mm²/s], n [rpm], d_m [mm]. The arguments and the result of the
/// function are in SI units. The factor f0 depends on bearing type and lubrication.
/// Source:   [Palmgren1959; CaseStudy, eq. 22].
/// Domain:   speed >= 0, viscosity > 0. At ν n = 2000 the two published formulas differ by 0.8 %.
///           The formula for ν n < 2000 is valid down to standstill.
template <typename T>
T palmgren_viscous_moment(const T& f0, const T& viscosity, const T& speed, double pitch_diameter) {
  using std::pow;
  const T nu_n = (viscosity / mm2_per_s) * (speed / rpm);
  const double d_m = pitch_diameter / mm;
  // The branch comes before the power, because the power has no derivative at standstill.
  const T drag = nu_n < 2000.0 ? T(160.0) : T(pow(nu_n, 2.0 / 3.0));
  return 1e-7 * f0 * drag * (d_m * d_m * d_m * N_mm);
}

}  // namespace raceway::friction
