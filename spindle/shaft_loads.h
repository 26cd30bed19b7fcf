#pragma once

#include <vector>

#include "spindle/loaded_shaft.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Returns the radial loads on the shaft of a spindle. The first element is the radial force along
/// y at the nose, with the moment in the same plane. The second element is the belt force, if the
/// model has a belt. The axial load is not included.
[[nodiscard]] std::vector<ShaftLoad> shaft_loads(const model::Spindle& spindle,
                                                 const Inputs& inputs);
/// Returns the positions of the loads of shaft_loads() [m].
[[nodiscard]] std::vector<double> load_places(const model::Spindle& spindle);

/// Returns the centres of the bearings of the sets on the shaft, front set first [m].
[[nodiscard]] std::vector<double> bearing_places(const model::Spindle& spindle);

/// Returns all bearings that support the shaft of a spindle. The result stores pointers into both
/// arguments, so both arguments must exist as long as the result.
[[nodiscard]] ShaftBearings bearings_of_shaft(const model::Spindle& spindle,
                                              const bearing::Arrangement& sets);
/// Returns the positions of all bearings and loads [m]. The beam model of the shaft needs a node at
/// each of these positions.
[[nodiscard]] std::vector<double> beam_places(const model::Spindle& spindle);

}  // namespace raceway::spindle
