#pragma once

#include <span>
#include <vector>

#include "shaft/fit_kinematic_law.h"

namespace raceway::shaft {

/// A displacement curve as it stands, for shapes that the kinematic law cannot take: points and the
/// slopes of a monotone cubic through them.
struct DisplacementTable {
  std::vector<double> speed;         ///< increasing [rad/s]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> slope;         ///< du/dω there [m s/rad]
  bool monotone = false;  ///< the displacement never turns; otherwise it turns where the points do
};

/// The table of a curve; rows of one speed are averaged.
///
/// Slopes by PCHIP [FritschCarlson1980], so between two points the cubic goes from one to the other
/// without a turn.
/// Throws std::invalid_argument: fewer than four different speeds, a value that is not finite.
[[nodiscard]] DisplacementTable make_displacement_table(std::span<const DisplacementPoint> curve);

/// The cubic through the table, at a speed [rad/s]; outside held at the nearer end and said so, as
/// evaluate() of the law does.
///
///   u = (1 + 2t)(1 - t)² u0 + t²(3 - 2t) u1 + h (t(1 - t)² m0 - t²(1 - t) m1),  t = (ω - ω0)/h
[[nodiscard]] KinematicDisplacement evaluate(const DisplacementTable& table, double speed);

}  // namespace raceway::shaft
