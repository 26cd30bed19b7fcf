#pragma once

#include <vector>

#include "spindle/loaded_shaft.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Loads across the shaft of a spindle: force and moment at the nose in the plane of y, then
/// the belt where there is one. The axial load is no part of it.
[[nodiscard]] std::vector<ShaftLoad> shaft_loads(const model::Spindle& spindle,
                                                 const Inputs& inputs);
/// Places where shaft_loads() act [m].
[[nodiscard]] std::vector<double> load_places(const model::Spindle& spindle);

/// Centres of the bearings of the sets on the shaft, front set first [m].
[[nodiscard]] std::vector<double> bearing_places(const model::Spindle& spindle);

/// All that holds the shaft of a spindle. Keeps pointers into both.
[[nodiscard]] ShaftBearings bearings_of_shaft(const model::Spindle& spindle,
                                              const bearing::Arrangement& sets);
/// Nodes that its beam must have: bearings, loads [m].
[[nodiscard]] std::vector<double> beam_places(const model::Spindle& spindle);

}  // namespace raceway::spindle
