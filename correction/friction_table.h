#pragma once

#include <string>
#include <vector>

namespace raceway::correction {

/// Friction torque of a whole spindle over speed, loads and temperature, on a grid.
///
/// A load counts by its amount where the axis of the table has no negative one.
struct FrictionTable {
  /// [rad/s], [N], [N], [K].
  struct Point {
    double speed, axial_load, radial_load, temperature;
  };

  std::string file{};  ///< as the model names it
  /// Rising, one value or more each; units as in Point.
  std::vector<double> speed{}, axial_load{0.0}, radial_load{0.0}, temperature{};
  /// [N m]; speed runs fastest, then axial load, radial load, temperature.
  std::vector<double> torque{};

  /// Interpolates linearly; outside of its axes the value at the edge holds.
  [[nodiscard]] double operator()(const Point& at) const;
  /// Returns true for a point within the axes; an axis of one value accepts all.
  [[nodiscard]] bool holds(const Point& at) const;
};

}  // namespace raceway::correction
