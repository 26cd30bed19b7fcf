#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::record {

/// Indices of rows that repeat one measurement.
using RepeatGroup = std::vector<std::size_t>;

/// Tolerances of the inputs. Two rows are at the same operating point if all their inputs agree
/// within these tolerances.
struct SamePoint {
  /// Tolerance for inputs whose Channel::ratio is true. The tolerance is relative to the largest
  /// absolute value of all inputs of the same kind, such as loads, in the two rows [1].
  double relative = 1e-3;
  /// Tolerance for all other inputs, such as temperatures [K]. A change of 0.1 K changes the
  /// viscosity of an oil by about 0.3 %.
  double temperature = 0.1;
};

/// Returns groups of two or more rows. All rows of a group agree with the first row of the group
/// within the tolerances `same`. The function searches `rows`, or all rows if `rows` is empty. A
/// coast-down has no groups, because the speed differs in every row. Rows of different joined
/// records are never in one group, because differences between days are not scatter.
[[nodiscard]] std::vector<RepeatGroup> find_repeats(const Record& record,
                                                    const SamePoint& same = {},
                                                    std::span<const std::size_t> rows = {});

}  // namespace raceway::record
