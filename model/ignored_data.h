#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// Those of the keys of a model file, all of bearings or of the solver, that change no digit of the
/// friction torque: neither the base law takes them in (friction::bearing_data()) nor an effect
/// that is switched on. One that looks at the balls takes in all.
[[nodiscard]] std::vector<std::string> ignored_by_friction(const Model& model,
                                                           std::span<const std::string> keys);

/// Of those keys what the law takes in.
[[nodiscard]] std::vector<std::string> taken_in(friction::FrictionLaw law,
                                                std::span<const std::string> keys);

}  // namespace raceway::model
