#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/channel.h"

namespace raceway::record {

/// Returns the lowest value of each level, in ascending order. A new level begins where
/// neighbouring sorted values differ by more than `width`. NaN values are skipped.
[[nodiscard]] std::vector<double> level_starts(std::span<const double> values, double width);

/// Returns the index of the level to which a value belongs; 0 for a value below all levels.
/// `starts` is the result of level_starts().
[[nodiscard]] std::size_t level_of(double value, std::span<const double> starts);

/// Returns the largest difference between neighbouring sorted values of one level [SI]:
/// Channel::step, multiplied by the largest absolute value in `values` if Channel::ratio is true.
[[nodiscard]] double step_of(const Channel& channel, std::span<const double> values);

}  // namespace raceway::record
