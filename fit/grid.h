#pragma once

#include <vector>

namespace raceway::fit {

/// Returns `count` values from low to high. If low > 0 and high > 3 low, neighbouring values have a
/// constant ratio, otherwise a constant difference. If high - low is at most 0.1 % of high, the
/// only value is the mean of low and high.
[[nodiscard]] std::vector<double> grid(double low, double high, int count);

}  // namespace raceway::fit
