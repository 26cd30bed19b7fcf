#include "fit/grid.h"

#include <cmath>

namespace raceway::fit {

std::vector<double> grid(double low, double high, int count) {
  if (!(high - low > 1e-3 * std::abs(high))) return {0.5 * (low + high)};
  std::vector<double> levels;
  const bool ratio = low > 0.0 && high > 3.0 * low;
  for (int k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / (count - 1);
    levels.push_back(ratio ? low * std::pow(high / low, part) : low + part * (high - low));
  }
  return levels;
}

}  // namespace raceway::fit
