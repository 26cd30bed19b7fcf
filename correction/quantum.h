#pragma once

#include <span>
#include <vector>

#include "record/channel.h"
#include "record/record.h"

namespace raceway::correction {

/// Returns the resolution of a column [SI]. The resolution is the smallest difference between two
/// different values. The result is NaN if the other differences between values are not multiples of
/// this smallest difference, or if the column has fewer than three or more than 2000
/// different values.
[[nodiscard]] double quantum_of(const record::Channel& channel, std::span<const double> values);

/// Limit for time steps of a record, in multiples of the median time step [1]. A longer time step
/// is a gap.
inline constexpr double a_gap = 20.0;

/// Longest period in which a column is constant, and the start of this period.
struct Still {
  double longest = 0.0, from = 0.0;  ///< duration and start [s]
};

/// Returns the longest period in which the values of a column are constant. A new run or a gap ends
/// the period, because the value may change during the gap.
[[nodiscard]] Still longest_still(const record::Record& record, std::span<const double> values);

/// Returns estimates of the quantity that a sensor with coarse resolution measures. At a change of
/// the reading, the true value is assumed halfway between the two readings. Between these changes,
/// the function interpolates linearly. If the trend reverses between two changes, an additional
/// point is used: midway in time between the two changes, the true value is assumed equal to the
/// reading. `begins` is true at the first row of a run.
[[nodiscard]] std::vector<double> between_digits(std::span<const double> time,
                                                 std::span<const double> values,
                                                 const std::vector<bool>& begins);

}  // namespace raceway::correction
