#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::record {

/// Indices of rows that repeat one measurement.
using RepeatGroup = std::vector<std::size_t>;

/// Tolerances of the inputs within which two rows belong to the same point.
struct SamePoint {
  /// Tolerance for inputs that are compared by ratio, relative to the largest value that the inputs
  /// of this kind, such as loads, have in the two rows [1].
  double relative = 1e-3;
  /// Tolerance for other inputs [K]. A change by the default changes the viscosity of an oil by
  /// about 0.3 %.
  double temperature = 0.1;
};

/// Returns groups of two or more rows at the same point. Only `rows` are used, or all rows if
/// `rows` is empty. If the speed falls continuously, all rows differ, so there are no groups. Rows
/// of different joined records never form a group, because differences between days are not
/// scatter.
[[nodiscard]] std::vector<RepeatGroup> find_repeats(const Record& record,
                                                    const SamePoint& same = {},
                                                    std::span<const std::size_t> rows = {});

}  // namespace raceway::record
