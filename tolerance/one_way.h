#pragma once

#include <cstddef>

#include "fit/separable.h"

namespace raceway::tolerance {

/// Returns true if the readings of a channel only rise or only fall, apart from small changes in
/// the other direction. An example is the warm-up of a machine. The result is true if the sum of
/// the absolute changes of the smoothed readings is less than 1.3 times their range. If a record
/// has such readings, a model that is fitted to some blocks of its rows cannot predict the other
/// blocks. The result is also true if the channel has no readings.
[[nodiscard]] bool goes_one_way(const fit::Means& means, std::size_t channel);

}  // namespace raceway::tolerance
