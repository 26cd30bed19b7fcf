#pragma once

#include <vector>

#include "spindle/thermal_system.h"

namespace raceway::spindle {

/// Returns the stresses of shaft and rings in each axial slice of the mesh. The stresses come from
/// the temperature distribution over the wall, from the seat pressure and from the rotation
/// (stresses_of()).
///
/// The surface temperature follows from the temperature of the outermost cell and the heat flow
/// through half of this cell. A ring with one cell over the radius therefore also has a temperature
/// gradient. Bending, axial preload, clamping, ball loads on the grooves, restraint by neighbouring
/// slices, and stress concentration at steps and keys are neglected. `raceways` is the heat that
/// enters each cell at a raceway [W]. `speed` is in rad/s.
[[nodiscard]] std::vector<SectionStress> stresses(const ThermalSystem& system,
                                                  const Vector& temperatures,
                                                  const Vector& raceways, double speed);

}  // namespace raceway::spindle
