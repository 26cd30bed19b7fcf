#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/channel.h"

namespace raceway::record {

/// The lowest value of each level, rising: a new one where sorted values step by more than `width`.
/// NaN is passed over.
[[nodiscard]] std::vector<double> level_starts(std::span<const double> values, double width);

/// Index of the level of a value, by the level starts.
[[nodiscard]] std::size_t level_of(double value, std::span<const double> starts);

/// The step of a channel over these values [SI].
[[nodiscard]] double step_of(const Channel& channel, std::span<const double> values);

}  // namespace raceway::record
