#pragma once

#include <vector>

#include "spindle/thermal_system.h"

namespace raceway::spindle {

/// Returns the stresses of shaft and rings in each column of cells. Causes are the temperature
/// across the wall, the pressure of the seat and the rotation (stresses_of()).
///
/// The temperature of a surface follows from the temperature of its cell and the heat flow through
/// half the cell, so a ring with one cell also has a gradient. Not included: bending, axial preload
/// and clamping, ball loads on the grooves, steps and keys, and the restraint by neighbouring
/// columns. `raceways` is the heat that enters each cell at its raceway [W].
[[nodiscard]] std::vector<SectionStress> stresses(const ThermalSystem& system,
                                                  const Vector& temperatures,
                                                  const Vector& raceways, double speed);

}  // namespace raceway::spindle
