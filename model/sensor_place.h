#pragma once

#include <utility>

#include "model/model.h"

namespace raceway::model {

/// Returns the axial range behind the nose face [m] in which a thermometer stays in its part at its
/// radius: adjacent segments of shaft or housing, or the width of a ring. If the thermometer is in
/// none of these parts, or in the coolant, both limits are its position.
[[nodiscard]] std::pair<double, double> reach_of(const Model& model,
                                                 const ThermometerPlace& sensor);

}  // namespace raceway::model
