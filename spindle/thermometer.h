#pragma once

#include "spindle/layout.h"

namespace raceway::spindle {

/// What a thermometer at a place reads: linear between the middles of the cells around it, that of
/// the nearest cell beyond the outermost middles. Shares sum up to 1.
/// Throws std::invalid_argument where there is no such part.
[[nodiscard]] Shares thermometer(const Mesh& mesh, const model::ThermometerPlace& place);

}  // namespace raceway::spindle
