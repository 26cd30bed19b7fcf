#pragma once

// Needs the standard library's <cmath> and <limits> and C++17, nothing else: this one file may be
// copied into a controller.

#include <cmath>
#include <limits>

namespace raceway::shaft {

/// Kinematic axial displacement of a shaft against its speed, as published.
///
///   u = A n^(1 - B exp(-C n))
///
/// Dimensional as published: u [um], n [rpm], A [um], B [1], C [1/rpm]; KinematicLaw converts.
/// Source:   [Brecher2021, eq. 10], with A = 1.28e-3, B = 0.697, C = 5.3e-4: 12.396 um at
///           10 000 rpm.
/// Domain:   n >= 0, B <= 1; at standstill u = 0 for B < 1.
/// Accuracy: rounding. As a model of a shaft it is a fit: see docs/kinematic-law.md for how good.
/// Traps:    n counts in rpm: A changes with the unit of n by a factor that depends on n, so the
///           three numbers cannot be carried over to rad/s or 1/s. The exponent runs from 1 - B at
///           standstill to 1, not to 0 (and not to 2, as centrifugal forces would have it): at high
///           speed u becomes A n. The slope at standstill is infinite for 0 < B < 1. The published
///           numbers bend at 111.28 and 5691.27 rpm (u'' = 0), so the slope is smallest at 111 rpm
///           and largest at 5691 rpm. A multiplies a power of a large number: its digits count as
///           B's do.
template <typename T>
T kinematic_displacement_um(double speed_rpm, const T& A, const T& B, const T& C) {
  using std::exp;
  if (!(speed_rpm > 0.0)) return T(speed_rpm == 0.0 ? 0.0 : speed_rpm - speed_rpm);
  return A * exp((1.0 - B * exp(-C * speed_rpm)) * std::log(speed_rpm));
}

/// Result of a law at one speed.
struct KinematicDisplacement {
  double displacement;  ///< of the shaft from its place at standstill, towards the tool [m]
  double slope;         ///< du/dω, a displacement over an angular speed [m s/rad]
  bool inside;          ///< false: the speed lies outside the range of the law; see there
};

/// The law with its numbers and the range of speeds that it was fitted to.
struct KinematicLaw {
  double A = std::numeric_limits<double>::quiet_NaN();  ///< [um], the displacement at 1 rpm
  double B = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double C = std::numeric_limits<double>::quiet_NaN();  ///< [1/rpm]
  double lowest_speed = 0.0;                            ///< [rad/s]
  double highest_speed = 0.0;                           ///< [rad/s]
};

/// Displacement and slope at a speed [rad/s].
///
///   du/dn = u/n (1 - B exp(-C n) (1 - C n ln n))
///
/// Domain:   lowest_speed <= speed <= highest_speed. Outside it does not extrapolate: the
///           displacement of the nearer end is held, with slope zero and `inside` false, so that a
///           control loop meets no step and no NaN. A speed that is no number gives NaN.
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
