#pragma once

#include <utility>

#include "model/model.h"

namespace raceway::model {

/// Returns the axial range behind the nose face [m] over which a thermometer can move at constant
/// radius without leaving the part that it measures: adjacent segments of shaft or housing, or the
/// width of a ring. If the thermometer is in none of these parts, or in the coolant, both limits
/// are its position.
[[nodiscard]] std::pair<double, double> reach_of(const Model& model,
                                                 const ThermometerPlace& sensor);

}  // namespace raceway::model
