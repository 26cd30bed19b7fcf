#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// Returns the keys among `keys` that do not change the friction torque: neither the base law
/// (friction::bearing_data()) nor an active effect uses them. An effect that uses the ball
/// equilibrium uses all keys except the keys of the contact law. For the laws `contact` and
/// `table`, the function does not check the keys, and the result is empty.
[[nodiscard]] std::vector<std::string> ignored_by_friction(const Model& model,
                                                           std::span<const std::string> keys);

/// Returns the keys among `keys` that the given law uses.
[[nodiscard]] std::vector<std::string> taken_in(friction::FrictionLaw law,
                                                std::span<const std::string> keys);

}  // namespace raceway::model
