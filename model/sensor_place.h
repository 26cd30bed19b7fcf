#pragma once

#include <utility>

#include "model/model.h"

namespace raceway::model {

/// Returns the axial range to which a thermometer could be moved without leaving its part, as
/// distances behind the nose face [m]. The radius of the thermometer is constant. A part is a ring
/// of a ball bearing, or adjacent segments of shaft or housing that have material at this radius.
/// If the thermometer is in the coolant or in none of these parts, both limits are its present
/// position.
[[nodiscard]] std::pair<double, double> reach_of(const Model& model,
                                                 const ThermometerPlace& sensor);

}  // namespace raceway::model
