#include "shaft/displacement_table.h"

// Boost 1.74's pchip.hpp calls isnan() unqualified, so the C header has to come before it.
#include <math.h>

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace raceway::shaft {
namespace {

/// Slope at the first of three points from the parabola through them, held where it would make the
/// cubic turn; Boost's own is the secant, good to first order only.
double end_slope(const double* x, const double* y, int step) {
  const double h0 = x[step] - x[0], h1 = x[2 * step] - x[step];
  const double s0 = (y[step] - y[0]) / h0, s1 = (y[2 * step] - y[step]) / h1;
  const double slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
  if (slope * s0 <= 0.0) return 0.0;
  return std::abs(slope) > 3.0 * std::abs(s0) ? 3.0 * s0 : slope;
}

}  // namespace

DisplacementTable make_displacement_table(std::span<const DisplacementPoint> curve) {
  std::map<double, std::pair<double, int>> sums;  // displacement and rows, by speed
  for (const DisplacementPoint& p : curve) {
    if (!std::isfinite(p.speed) || !std::isfinite(p.displacement))
      throw std::invalid_argument("a displacement table needs finite speeds and displacements");
    auto& [sum, rows] = sums[p.speed];
    sum += p.displacement;
    ++rows;
  }
  if (sums.size() < 4)
    throw std::invalid_argument("a displacement table needs at least four different speeds");
  DisplacementTable table;
  for (const auto& [speed, sum] : sums) {
    table.speed.push_back(speed);
    table.displacement.push_back(sum.first / sum.second);
  }
  const boost::math::interpolators::pchip<std::vector<double>> cubic(
      std::vector(table.speed), std::vector(table.displacement),
      end_slope(&table.speed.front(), &table.displacement.front(), 1),
      end_slope(&table.speed.back(), &table.displacement.back(), -1));
  for (const double speed : table.speed) table.slope.push_back(cubic.prime(speed));
  table.monotone = std::is_sorted(table.displacement.begin(), table.displacement.end()) ||
                   std::is_sorted(table.displacement.rbegin(), table.displacement.rend());
  return table;
}

KinematicDisplacement evaluate(const DisplacementTable& table, double speed) {
  if (speed < table.speed.front()) return {table.displacement.front(), 0.0, false};
  if (speed > table.speed.back()) return {table.displacement.back(), 0.0, false};
  if (std::isnan(speed)) return {unset, unset, false};
  const auto above = std::upper_bound(table.speed.begin() + 1, table.speed.end() - 1, speed);
  const auto k = static_cast<std::size_t>(above - table.speed.begin());
  const double h = table.speed[k] - table.speed[k - 1];
  const double t = (speed - table.speed[k - 1]) / h, s = 1.0 - t;
  const double u0 = table.displacement[k - 1], u1 = table.displacement[k];
  const double m0 = table.slope[k - 1], m1 = table.slope[k];
  return {(1.0 + 2.0 * t) * s * s * u0 + t * t * (3.0 - 2.0 * t) * u1 +
              h * (t * s * s * m0 - t * t * s * m1),
          6.0 * t * s * (u1 - u0) / h + s * (1.0 - 3.0 * t) * m0 + t * (3.0 * t - 2.0) * m1, true};
}

}  // namespace raceway::shaft
