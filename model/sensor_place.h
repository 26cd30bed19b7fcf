#pragma once

#include <utility>

#include "model/model.h"

namespace raceway::model {

/// Positions along the axis, behind the nose face [m], between which a thermometer stays in its
/// part at its radius: rows of segments of shaft or housing, the width of a bearing for a ring.
/// Both are its own position where it lies in no such part, or in the coolant.
[[nodiscard]] std::pair<double, double> reach_of(const Model& model,
                                                 const ThermometerPlace& sensor);

}  // namespace raceway::model
