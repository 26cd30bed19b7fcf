#pragma once

#include <string>
#include <vector>

namespace raceway::correction {

/// Friction torque of a whole spindle over speed, load and temperature, on a grid.
struct FrictionTable {
  std::string file{};  ///< as the model names it
  /// Rising, one value or more each. [rad/s], [N], [K].
  std::vector<double> speed{}, axial_load{}, temperature{};
  /// [N m]; speed runs fastest, then load, then temperature.
  std::vector<double> torque{};

  /// Interpolates linearly; outside of its axes the value at the edge holds.
  [[nodiscard]] double operator()(double of_speed, double load, double of_temperature) const;
  /// Returns true for a point within the axes; an axis of one value accepts all.
  [[nodiscard]] bool holds(double of_speed, double load, double of_temperature) const;
};

}  // namespace raceway::correction
