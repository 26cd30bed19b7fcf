#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// Returns the keys among `keys` (keys of a model file) that do not affect the friction torque,
/// because neither the base law (friction::bearing_data()) nor an effect uses them. If the law or
/// an effect uses the ball equilibrium, the torque depends on nearly all bearing data; in this
/// case, the result contains only keys that no law except `contact` uses, such as
/// `race_roughness_um`. For the laws `contact` and `table`, the result is empty.
[[nodiscard]] std::vector<std::string> ignored_by_friction(const Model& model,
                                                           std::span<const std::string> keys);

/// Returns the keys among `keys` that the friction law uses.
[[nodiscard]] std::vector<std::string> taken_in(friction::FrictionLaw law,
                                                std::span<const std::string> keys);

}  // namespace raceway::model
