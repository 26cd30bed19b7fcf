#pragma once

#include <span>
#include <vector>

#include "record/channel.h"
#include "record/record.h"

namespace raceway::correction {

/// Returns the resolution of a column [SI]: the smallest difference between two values, if all
/// other differences are multiples of it. The result is NaN if the differences are not such
/// multiples, and for fewer than three or more than 2000 different values.
[[nodiscard]] double quantum_of(const record::Channel& channel, std::span<const double> values);

/// Limit for time steps of a record, in multiples of the median step [1]. A longer step is a gap.
inline constexpr double a_gap = 20.0;

/// Longest time without a change of a column, and the time at which it begins.
struct Still {
  double longest = 0.0, from = 0.0;  ///< duration and start [s]
};

/// Returns the longest time for which the values of a column are constant. A new run or a gap ends
/// this time, because the value may change in between.
[[nodiscard]] Still longest_still(const record::Record& record, std::span<const double> values);

/// Returns estimates of the true values of a sensor with coarse resolution. At a change of the
/// reading, the true value is assumed halfway between the two readings. Between these changes, the
/// function interpolates linearly. If the trend reverses between two changes, the true value is
/// assumed equal to the reading at the time midway between them. `begins` is true at the first row
/// of a run.
[[nodiscard]] std::vector<double> between_digits(std::span<const double> time,
                                                 std::span<const double> values,
                                                 const std::vector<bool>& begins);

}  // namespace raceway::correction
