#pragma once

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Largest Hertz pressures over the balls of a bearing [Pa]; 0 for a race that no ball touches, and
/// NaN if the equilibrium did not converge.
struct ContactPressure {
  double inner = unset, outer = unset;
};

[[nodiscard]] ContactPressure largest_pressure(const Bearing& bearing,
                                               const BearingEquilibrium& equilibrium);

/// Hertz pressure that defines the static rating of ball bearings [Pa]. This pressure leaves a
/// permanent dent of 1/10 000 of the ball diameter.
/// Source: [ISO76].
inline constexpr double static_limit_pressure = 4200e6;

}  // namespace raceway::bearing
