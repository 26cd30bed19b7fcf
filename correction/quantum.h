#pragma once

#include <span>
#include <vector>

#include "record/channel.h"

namespace raceway::correction {

/// The last digit of a column [SI]: the greatest step of which all differences are multiples. NaN
/// where there is none, or fewer than three values.
[[nodiscard]] double quantum_of(const record::Channel& channel, std::span<const double> values);

/// Likely values between the steps of a sensor: straight between the changes of its last digit,
/// where the value is half-way, and at the digit itself in the middle of a turn. `begins`: a run
/// begins with this row.
[[nodiscard]] std::vector<double> between_digits(std::span<const double> time,
                                                 std::span<const double> values,
                                                 const std::vector<bool>& begins);

}  // namespace raceway::correction
