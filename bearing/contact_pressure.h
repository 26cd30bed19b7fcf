#pragma once

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Largest Hertz pressures over the balls of a bearing [Pa]; 0 where no ball touches that race, NaN
/// without balance.
struct ContactPressure {
  double inner = unset, outer = unset;
};

[[nodiscard]] ContactPressure largest_pressure(const Bearing& bearing,
                                               const BearingEquilibrium& equilibrium);

/// Hertz pressure under which a ball contact keeps a dent of a ten thousandth of the ball's
/// diameter, by which static ratings of ball bearings are defined [Pa]. Source: [ISO76].
inline constexpr double static_limit_pressure = 4200e6;

}  // namespace raceway::bearing
