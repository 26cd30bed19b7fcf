#pragma once

#include <span>
#include <vector>

#include "record/channel.h"
#include "record/record.h"

namespace raceway::correction {

/// The last digit of a column [SI]: the greatest step of which all differences are multiples. NaN
/// where there is none, or fewer than three values.
[[nodiscard]] double quantum_of(const record::Channel& channel, std::span<const double> values);

/// Times the usual step of time: a gap, which has no readings.
inline constexpr double a_gap = 20.0;

/// Longest time for which a column of a record read the same.
struct Still {
  double longest = 0.0, from = 0.0;  ///< [s]
};

/// The longest time for which values of a record stood still. Neither a new run nor a gap goes on
/// with it: a sensor that reads the same behind a gap need not have stood.
[[nodiscard]] Still longest_still(const record::Record& record, std::span<const double> values);

/// Likely values between the steps of a sensor: straight between the changes of its last digit,
/// where the value is half-way, and at the digit itself in the middle of a turn. `begins`: a run
/// begins with this row.
[[nodiscard]] std::vector<double> between_digits(std::span<const double> time,
                                                 std::span<const double> values,
                                                 const std::vector<bool>& begins);

}  // namespace raceway::correction
