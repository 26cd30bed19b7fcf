#pragma once

#include <vector>

namespace raceway::fit {

/// Returns `count` levels from low to high. The levels have equal ratios if the range is wide,
/// otherwise equal steps. An empty range gives one level.
[[nodiscard]] std::vector<double> grid(double low, double high, int count);

}  // namespace raceway::fit
