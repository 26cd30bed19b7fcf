#pragma once

#include <span>
#include <vector>

#include "record/channel.h"
#include "record/record.h"

namespace raceway::correction {

/// Returns the resolution of a column [SI], which is one step of its last digit: the smallest
/// difference between two values, if all other differences are multiples of the smallest one. If
/// the other differences are not multiples, the result is NaN. The result is also NaN for fewer
/// than three or more than 2000 different values.
[[nodiscard]] double quantum_of(const record::Channel& channel, std::span<const double> values);

/// Longest time step within a record, in multiples of the usual step. A longer step is a gap
/// without readings.
inline constexpr double a_gap = 20.0;

/// Longest time for which a column kept the same value.
struct Still {
  double longest = 0.0, from = 0.0;  ///< [s]
};

/// Returns the longest time for which the values of a record stayed constant. A new run or a gap
/// ends such a time, because the value may have changed in between.
[[nodiscard]] Still longest_still(const record::Record& record, std::span<const double> values);

/// Returns likely values between the steps of a sensor. At a change of the last digit, the true
/// value is assumed halfway between the two readings. The function interpolates between these
/// changes. Where the trend reverses between two changes, the value at the middle time is the
/// reading itself. `begins` is true at the first row of a run.
[[nodiscard]] std::vector<double> between_digits(std::span<const double> time,
                                                 std::span<const double> values,
                                                 const std::vector<bool>& begins);

}  // namespace raceway::correction
