#pragma once

#include <vector>

namespace raceway::fit {

/// `count` levels from low to high, in ratio where that is wide; one where there is no range.
[[nodiscard]] std::vector<double> grid(double low, double high, int count);

}  // namespace raceway::fit
