#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace raceway::life {

/// Value of y at `at`: linear between the points of a printed table, constant beyond its ends; NaN
/// if `at` is NaN. x must increase.
[[nodiscard]] inline double between(std::span<const double> x, std::span<const double> y,
                                    double at) {
  if (!(at > x.front())) return at == at ? y.front() : at;
  if (at >= x.back()) return y.back();
  const auto k = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  const double share = (at - x[k - 1]) / (x[k] - x[k - 1]);
  return y[k - 1] + share * (y[k] - y[k - 1]);
}

}  // namespace raceway::life
