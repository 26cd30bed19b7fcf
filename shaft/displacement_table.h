#pragma once

#include <span>
#include <vector>

#include "shaft/fit_kinematic_law.h"

namespace raceway::shaft {

/// Table of displacement over speed, for curves that the kinematic law (kinematic_law.h) cannot
/// follow. A piecewise cubic passes through the points and is monotone between neighbouring points.
struct DisplacementTable {
  std::vector<double> speed;         ///< increasing [rad/s]
  std::vector<double> displacement;  ///< displacement at each speed [m]
  std::vector<double> slope;         ///< slope du/dω at each speed [m s/rad]
  /// True if the displacement only rises or only falls over the whole table. If false, every
  /// maximum and minimum is at a point of the table.
  bool monotone = false;
};

/// Makes a displacement table from the points of a curve. Points with the same speed are averaged.
///
/// The slopes come from the PCHIP method [FritschCarlson1980], so the cubic has no turning point
/// between two points. Throws std::invalid_argument for fewer than four different speeds and for a
/// value that is not finite.
[[nodiscard]] DisplacementTable make_displacement_table(std::span<const DisplacementPoint> curve);

/// Evaluates the cubic of a table at a speed ω [rad/s]. The indices 0 and 1 mean the table points
/// below and above this speed; u is the displacement and m the slope at a point. Outside the table,
/// the function returns the displacement of the nearer end, slope 0 and `inside` false. A NaN speed
/// gives NaN.
///
///   u = (1 + 2t)(1 - t)² u0 + t²(3 - 2t) u1 + h (t(1 - t)² m0 - t²(1 - t) m1),  t = (ω - ω0)/h,
///   h = ω1 - ω0
[[nodiscard]] KinematicDisplacement evaluate(const DisplacementTable& table, double speed);

}  // namespace raceway::shaft
