#pragma once

#include <cstddef>

#include "fit/separable.h"

namespace raceway::tolerance {

/// True where the readings of a channel go from one state to another once, as while a machine warms
/// up: the way that their means go is hardly longer than their span. No part of such a record can
/// be held out and told from the rest. True without readings.
[[nodiscard]] bool goes_one_way(const fit::Means& means, std::size_t channel);

}  // namespace raceway::tolerance
