#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Extrapolates laws beyond the input range of the fit.
namespace raceway::correction {

struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(double x) const { return x >= lower && x <= upper; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Evaluates a law y(x) at x. Within the range `seen` of the fit, the result is the law. Beyond
/// this range, the result changes no faster than the tangent at the edge of the range:
///
///   y(edge) + the smaller change of   law(x) - y(edge)   and   y'(edge) (x - edge)
///
/// If the two changes have different signs, the value at the edge is used. The result lies between
/// the value at the edge and the law, so it is positive if the law is positive.
/// Accuracy: the slope y'(edge) is a finite difference over a millionth of the range.
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
