#pragma once

#include <string>
#include <vector>

namespace raceway::correction {

/// Friction torque of a whole spindle on a grid of speed, loads and temperature.
///
/// The absolute value of a load is used, unless the axis of this load contains negative values.
struct FrictionTable {
  /// Units: [rad/s], [N], [N], [K].
  struct Point {
    double speed, axial_load, radial_load, temperature;
  };

  std::string file{};  ///< file name as in the model
  /// Axes, each with one or more rising values; units as in Point.
  std::vector<double> speed{}, axial_load{0.0}, radial_load{0.0}, temperature{};
  /// Friction torque [N m]; speed varies fastest, then axial load, radial load and temperature.
  std::vector<double> torque{};

  /// Interpolates linearly. Beyond the end of an axis, the value at its end is used.
  [[nodiscard]] double operator()(const Point& at) const;
  /// Returns true for a point within the axes. An axis with one value accepts all points.
  [[nodiscard]] bool holds(const Point& at) const;
};

}  // namespace raceway::correction
