#pragma once

#include <vector>

#include "record/record.h"

namespace raceway::record {

/// Rows that measure the same: indices into a record.
using RepeatGroup = std::vector<std::size_t>;

/// Limits within which two rows are at the same point: no input differs by more.
struct SamePoint {
  double relative = 1e-3;    ///< for inputs compared by ratio [1]
  double temperature = 0.1;  ///< otherwise [K]; 0.3 % of a viscosity
};

/// Groups of two or more rows at the same point, of those in `rows` (all where empty). A speed that
/// falls all the time differs from row to row: then there are none. Rows of two joined records are
/// none: what differs from day to day is no scatter.
[[nodiscard]] std::vector<RepeatGroup> find_repeats(const Record& record,
                                                    const SamePoint& same = {},
                                                    std::span<const std::size_t> rows = {});

}  // namespace raceway::record
