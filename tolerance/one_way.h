#pragma once

#include <cstddef>

#include "fit/separable.h"

namespace raceway::tolerance {

/// Returns true if the readings of a channel change essentially in one direction, for example while
/// a machine warms up. The sum of the magnitudes of all changes of the smoothed readings is then
/// less than 1.3 times their range. In such a record, no block can be predicted from the other
/// blocks. The result is also true if the channel has no readings.
[[nodiscard]] bool goes_one_way(const fit::Means& means, std::size_t channel);

}  // namespace raceway::tolerance
