#pragma once

#include <string>
#include <vector>

namespace raceway::correction {

/// Friction torque of a whole spindle on a grid of speed, loads and temperature.
///
/// If the axis of a load has no negative values, the table uses the absolute value of the load.
struct FrictionTable {
  /// Operating point: speed [rad/s], axial load [N], radial load [N] and temperature [K].
  struct Point {
    double speed, axial_load, radial_load, temperature;
  };

  std::string file{};  ///< file name as in the model file
  /// Grid values of the four axes, in rising order and in the units of Point. Each axis has at
  /// least one value.
  std::vector<double> speed{}, axial_load{0.0}, radial_load{0.0}, temperature{};
  /// Friction torque at each grid point [N m]. In the list, speed varies fastest, then axial load,
  /// then radial load, and temperature varies slowest.
  std::vector<double> torque{};

  /// Returns the torque [N m], interpolated linearly. Beyond the end of an axis, the torque at this
  /// end of the axis is used.
  [[nodiscard]] double operator()(const Point& at) const;
  /// Returns true if a point lies within the range of every axis. An axis with a single value does
  /// not limit the range.
  [[nodiscard]] bool holds(const Point& at) const;
};

}  // namespace raceway::correction
