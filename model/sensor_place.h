#pragma once

#include <utility>

#include "model/model.h"

namespace raceway::model {

/// Returns the axial range to which a thermometer could be moved without leaving its part, as
/// distances behind the nose face [m]. The radius of the thermometer is constant. A part is a ring,
/// or adjacent segments of shaft or housing. If the thermometer is not in such a part, both limits
/// are its present position. This also applies to a thermometer in the coolant.
[[nodiscard]] std::pair<double, double> reach_of(const Model& model,
                                                 const ThermometerPlace& sensor);

}  // namespace raceway::model
