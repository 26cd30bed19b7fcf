#pragma once

#include <array>
#include <limits>

#include "record/parameter.h"

namespace raceway::correction {

/// Constants of several effects: an infinite bound, and the parameters gain and time constant.
inline constexpr double any_size = std::numeric_limits<double>::infinity();
inline constexpr record::NumberCard gain_number{"gain", "um/u", 0.0, -any_size, any_size};
/// Time constant [s]. A fit uses narrower bounds that depend on the duration and the sampling
/// interval of the record.
inline constexpr record::NumberCard time_constant_number{
    "time_constant_s", "s", 3600, 1.0, 1e7, 1.0, 1e7, unset};
inline constexpr std::array gain_and_time_constant{gain_number, time_constant_number};

}  // namespace raceway::correction
