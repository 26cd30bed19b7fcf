#pragma once

#include <vector>

namespace raceway::fit {

/// Returns `count` values from low to high. The values have equal ratios if low > 0 and
/// high > 3 low, otherwise equal steps. If the range is at most 0.1 % of high, the only value is
/// the middle of the range.
[[nodiscard]] std::vector<double> grid(double low, double high, int count);

}  // namespace raceway::fit
