#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "record/units.h"

namespace raceway::record {

/// The value in the middle of an odd number, the upper one of the middle two of an even number; NaN
/// of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return unset;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace raceway::record
