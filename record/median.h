#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "record/units.h"

namespace raceway::record {

/// Returns the median; NaN if there are no values. For an even number of values, the result is the
/// larger of the two middle values.
inline double median(std::vector<double> values) {
  if (values.empty()) return unset;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace raceway::record
