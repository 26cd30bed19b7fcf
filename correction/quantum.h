#pragma once

#include <span>
#include <vector>

namespace raceway::correction {

/// The least step of a sensor: all values lie on multiples of it, counted from one of them. NaN
/// where they do not, or are all the same.
[[nodiscard]] double quantum_of(std::span<const double> values);

/// What a sensor of that quantum may have stood at: straight between the changes of its last digit,
/// where the value is half-way, and at the digit itself in the middle of a turn. `begins`: a run
/// begins with this row.
[[nodiscard]] std::vector<double> between_digits(std::span<const double> time,
                                                 std::span<const double> values,
                                                 const std::vector<bool>& begins);

}  // namespace raceway::correction
