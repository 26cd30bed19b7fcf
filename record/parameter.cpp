#include "record/parameter.h"

#include <algorithm>
#include <cmath>

namespace raceway::record {

double typical_size(double start, double initial, double lower, double upper) {
  const double size = std::max(std::abs(start), std::abs(initial));
  if (size > 0.0) return size;
  const double range = upper - lower;
  return std::isfinite(range) && range > 0.0 ? 0.01 * range : 1.0;
}

}  // namespace raceway::record
