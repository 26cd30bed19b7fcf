#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Extrapolates formulas beyond the input range of the data to which they were fitted.
namespace raceway::correction {

struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(double x) const { return x >= lower && x <= upper; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Evaluates a formula y(x). Inside `seen`, the range of x in the data of the fit, the result is
/// y(x). Outside this range, the result is y(e) plus a change. e is the end of the range next to x,
/// and the change is the one of these two with the smaller absolute value:
///
///   y(x) - y(e)      change of the formula
///   y'(e) (x - e)    change along the tangent at e
///
/// If the two changes have opposite signs, the result is y(e). The result always lies between y(e)
/// and y(x), so a positive y gives a positive result.
/// Accuracy: the slope y'(e) is a finite difference. The step of this difference is a millionth of
///           the width of the range.
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
