#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "record/channel.h"

namespace raceway::record {

/// Returns the lowest value of each level, in ascending order. A new level begins if sorted values
/// differ by more than `width`. NaN values are skipped.
[[nodiscard]] std::vector<double> level_starts(std::span<const double> values, double width);

/// Returns the index of the level of a value. `starts` are the lowest values of all levels.
[[nodiscard]] std::size_t level_of(double value, std::span<const double> starts);

/// Returns the step of a channel for these values [SI]. Values whose difference is smaller than the
/// step belong to one level.
[[nodiscard]] double step_of(const Channel& channel, std::span<const double> values);

}  // namespace raceway::record
