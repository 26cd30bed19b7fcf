#pragma once

#include <vector>

namespace raceway::fit {

/// Returns `count` levels from low to high, spaced by ratio if the range is wide. An empty range
/// gives one level.
[[nodiscard]] std::vector<double> grid(double low, double high, int count);

}  // namespace raceway::fit
