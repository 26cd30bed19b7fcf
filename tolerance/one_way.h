#pragma once

#include <cstddef>

#include "fit/separable.h"

namespace raceway::tolerance {

/// Returns true if the readings of a channel only move once from one state to another, for example
/// while a machine warms up. The total path of the smoothed readings is then less than 1.3 times
/// the span between their lowest and highest value. In such a record, no part can be held out and
/// predicted from the other parts. The result is also true without readings.
[[nodiscard]] bool goes_one_way(const fit::Means& means, std::size_t channel);

}  // namespace raceway::tolerance
