#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Range of an input in the data of the fit, and continuation of laws beyond it.
namespace raceway::correction {

struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(double x) const { return x >= lower && x <= upper; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// A law at x, within what was seen the law itself, beyond it never steeper than a straight line.
///
///   y(edge) + what moves less of   law(x) - y(edge)   and   y'(edge) (x - edge)
///
/// Where the two part ways, the value at the edge. It lies between the edge and the law, and so is
/// positive where the law is.
/// Accuracy: the slope at the edge is a difference over a millionth of what was seen, to its
/// inside.
template <typename Law>
[[nodiscard]] double continued(const Law& law, const Interval& seen, double x) {
  if (!(x < seen.lower) && !(x > seen.upper)) return law(x);
  const double edge = std::clamp(x, seen.lower, seen.upper);
  const double width = std::isfinite(seen.upper - seen.lower) ? seen.upper - seen.lower : 0.0;
  const double step = 1e-6 * (width > 0.0 ? width : std::max(std::abs(edge), 1e-6));
  const double inside = edge + (x > edge ? -step : step);
  const double at_edge = law(edge);
  const double along = (at_edge - law(inside)) / (edge - inside) * (x - edge);
  const double by_law = law(x) - at_edge;
  if (along * by_law <= 0.0) return at_edge;
  return at_edge + (std::abs(along) < std::abs(by_law) ? along : by_law);
}

}  // namespace raceway::correction
