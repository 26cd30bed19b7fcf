#pragma once

#include <span>
#include <string_view>
#include <tuple>

#include "effects/effect.h"
#include "effects/spin_friction.h"

namespace raceway::effects {

/// Every effect there is. A new one is its file and its name here.
using Catalogue = std::tuple<SpinFriction>;

/// The catalogue with its types erased, in the order of the list.
[[nodiscard]] std::span<const Description> catalogue();

/// The effect of that id, null if there is none.
[[nodiscard]] const Description* find(std::string_view id);

}  // namespace raceway::effects
