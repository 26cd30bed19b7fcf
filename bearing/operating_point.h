#pragma once

#include "record/units.h"

namespace raceway::bearing {

/// Speed, loads and moments on the inner ring of one bearing. x is along the shaft, y and z are
/// radial, and the axes are right-handed. The inner ring rotates, the outer ring is stationary.
struct OperatingPoint {
  /// Speed of the shaft relative to the housing [rad/s], >= 0. The direction of rotation has no
  /// effect.
  double speed = 0.0;
  double axial_load = 0.0;     ///< F_x [N]
  double radial_load = 0.0;    ///< F_y [N]
  double radial_load_z = 0.0;  ///< F_z [N]
  double moment_y = 0.0;  ///< M_y, right-handed, at the plane of the inner groove centres [N m]
  double moment_z = 0.0;  ///< M_z, right-handed [N m]
  double temperature = celsius_zero + 40.0;  ///< lubricant temperature [K]
};

/// Throws std::invalid_argument if the speed is outside 0 to 1e6 rpm, a load is outside ±1e8 N, or
/// a moment is outside ±1e8 N m. Throws also if one of these values is NaN.
void validate(const OperatingPoint& point);

}  // namespace raceway::bearing
