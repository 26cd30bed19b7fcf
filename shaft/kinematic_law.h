#pragma once

// This file needs only <cmath> and <limits> of the standard library and C++17, so it may be copied
// into a controller.

#include <cmath>
#include <limits>

namespace raceway::shaft {

/// Returns the kinematic axial displacement u of a shaft at the speed n, by the kinematic law of
/// [Brecher2021].
///
///   u = A n^(1 - B exp(-C n))
///
/// Units as published: u [um], n [rpm], A [um], B [1], C [1/rpm]. evaluate() uses SI units.
/// Source:   [Brecher2021, eq. 10], with A = 1.28e-3, B = 0.697, C = 5.3e-4: 12.396 um at
///           10 000 rpm.
/// Domain:   n >= 0, B <= 1; at standstill u = 0 for B < 1.
/// Accuracy: the result has only rounding errors. docs/kinematic-law.md shows how to judge the fit
///           of the law to a curve.
/// Traps:    n is in rpm. Another unit of n changes A by a factor that depends on n, so the three
///           parameters cannot be converted to rad/s or 1/s. The exponent of n rises from 1 - B at
///           standstill to 1 at high speed, so u becomes A n at high speed. Centrifugal forces, in
///           contrast, grow with n². The slope at standstill is infinite for 0 < B < 1. With the
///           published parameters, the slope has a minimum at 111.28 rpm and a maximum at 5691.27
///           rpm. Do not round A: the relative error of u is the relative error of A.
template <typename T>
T kinematic_displacement_um(double speed_rpm, const T& A, const T& B, const T& C) {
  using std::exp;
  if (!(speed_rpm > 0.0)) return T(speed_rpm == 0.0 ? 0.0 : speed_rpm - speed_rpm);
  return A * exp((1.0 - B * exp(-C * speed_rpm)) * std::log(speed_rpm));
}

/// Displacement of a shaft at one speed, from a law or a table.
struct KinematicDisplacement {
  /// Position of the shaft relative to standstill, positive towards the tool [m].
  double displacement;
  double slope;  ///< derivative of the displacement with respect to the angular speed [m s/rad]
  bool inside;   ///< false: the speed is outside the range of the law or table
};

/// Parameters of the kinematic law, and the speed range of the fitted data.
struct KinematicLaw {
  double A = std::numeric_limits<double>::quiet_NaN();  ///< displacement at 1 rpm [um]
  double B = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double C = std::numeric_limits<double>::quiet_NaN();  ///< [1/rpm]
  double lowest_speed = 0.0;                            ///< [rad/s]
  double highest_speed = 0.0;                           ///< [rad/s]
};

/// Returns displacement u and slope at a speed [rad/s]; kinematic_displacement_um() explains the
/// symbols.
///
///   du/dn = u/n (1 - B exp(-C n) (1 - C n ln n))
///
/// Domain:   lowest_speed <= speed <= highest_speed. Outside this range, the function does not
///           extrapolate. It returns the displacement at the nearer end of the range, slope zero
///           and `inside` = false, so that a control loop gets neither a step nor a NaN. A NaN
///           speed gives a NaN displacement.
/// Traps:    the slope at standstill is infinite for 0 < B < 1.
inline KinematicDisplacement evaluate(const KinematicLaw& law, double speed) {
  constexpr double rpm = 3.14159265358979323846 / 30.0, um = 1e-6;
  const bool below = speed < law.lowest_speed;
  const bool above = speed > law.highest_speed;
  const double n = (below ? law.lowest_speed : above ? law.highest_speed : speed) / rpm;
  const double u = kinematic_displacement_um(n, law.A, law.B, law.C) * um;
  if (below || above) return {u, 0.0, false};
  if (n == 0.0) {
    const double steep = std::copysign(std::numeric_limits<double>::infinity(), law.A);
    return {u, (law.B == 0.0 ? law.A * um : steep) / rpm, true};
  }
  const double growth = 1.0 - law.B * std::exp(-law.C * n) * (1.0 - law.C * n * std::log(n));
  return {u, u / n * growth / rpm, n >= 0.0};
}

}  // namespace raceway::shaft
