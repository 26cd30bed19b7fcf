#pragma once

#include "spindle/layout.h"

namespace raceway::spindle {

/// Returns the weights of cell temperatures in the reading of a thermometer. The reading is
/// interpolated linearly between the middles of the surrounding cells. Between the middle of the
/// outermost cell and the face of a part, the reading is extrapolated linearly. The weights have
/// the sum 1. Throws std::invalid_argument if the spindle does not have the part in which the
/// thermometer is mounted.
[[nodiscard]] Shares thermometer(const Mesh& mesh, const model::ThermometerPlace& place);

}  // namespace raceway::spindle
