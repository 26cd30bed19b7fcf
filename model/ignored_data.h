#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// Keys of a model file, all of bearings or of the solver, that do not change the friction torque:
/// neither the base law (friction::bearing_data()) nor an active effect uses them. An effect that
/// looks at the balls uses all.
[[nodiscard]] std::vector<std::string> ignored_by_friction(const Model& model,
                                                           std::span<const std::string> keys);

/// Keys among these that the law uses.
[[nodiscard]] std::vector<std::string> taken_in(friction::FrictionLaw law,
                                                std::span<const std::string> keys);

}  // namespace raceway::model
