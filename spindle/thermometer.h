#pragma once

#include "spindle/layout.h"

namespace raceway::spindle {

/// Returns the reading of a thermometer as weights of cells: linear between the middles of the
/// surrounding cells. Beyond the outermost middles, the nearest cell is used. The weights have the
/// sum 1. Throws std::invalid_argument if the part does not exist.
[[nodiscard]] Shares thermometer(const Mesh& mesh, const model::ThermometerPlace& place);

}  // namespace raceway::spindle
