#pragma once

#include "spindle/layout.h"

namespace raceway::spindle {

/// Reading of a thermometer at a place: linear between the middles of the cells around it, beyond
/// the outermost middles the value of the nearest cell. Shares sum up to 1.
/// Throws std::invalid_argument where there is no such part.
[[nodiscard]] Shares thermometer(const Mesh& mesh, const model::ThermometerPlace& place);

}  // namespace raceway::spindle
