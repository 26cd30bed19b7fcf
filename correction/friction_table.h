#pragma once

#include <string>
#include <vector>

namespace raceway::correction {

/// Friction torque of a whole spindle on a grid of speed, loads and temperature.
///
/// The table is read at the absolute value of a load, unless the axis of the load contains negative
/// values.
struct FrictionTable {
  /// Units: [rad/s], [N], [N], [K].
  struct Point {
    double speed, axial_load, radial_load, temperature;
  };

  std::string file{};  ///< file name as in the model file
  /// Axes, each with one or more rising values; units as in Point.
  std::vector<double> speed{}, axial_load{0.0}, radial_load{0.0}, temperature{};
  /// Friction torque [N m]; speed varies fastest, then axial load, radial load and temperature.
  std::vector<double> torque{};

  /// Returns the torque [N m], interpolated linearly. Beyond the end of an axis, the value at its
  /// end is used.
  [[nodiscard]] double operator()(const Point& at) const;
  /// Returns true if a point lies within the range of every axis. An axis with one value has no
  /// limits.
  [[nodiscard]] bool holds(const Point& at) const;
};

}  // namespace raceway::correction
