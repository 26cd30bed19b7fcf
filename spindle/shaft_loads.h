#pragma once

#include <vector>

#include "spindle/loaded_shaft.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Returns the radial loads on the shaft of a spindle: force and moment at the nose in the plane of
/// y, then the belt load if there is one. The axial load is not included.
[[nodiscard]] std::vector<ShaftLoad> shaft_loads(const model::Spindle& spindle,
                                                 const Inputs& inputs);
/// Returns the places at which the loads of shaft_loads() act [m].
[[nodiscard]] std::vector<double> load_places(const model::Spindle& spindle);

/// Returns the centres of the bearings of the sets on the shaft, front set first [m].
[[nodiscard]] std::vector<double> bearing_places(const model::Spindle& spindle);

/// Returns all bearings that support the shaft of a spindle. The result stores pointers to both
/// arguments.
[[nodiscard]] ShaftBearings bearings_of_shaft(const model::Spindle& spindle,
                                              const bearing::Arrangement& sets);
/// Returns the places at which the beam needs nodes: bearings and loads [m].
[[nodiscard]] std::vector<double> beam_places(const model::Spindle& spindle);

}  // namespace raceway::spindle
