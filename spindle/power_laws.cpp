#include "spindle/power_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace raceway::spindle {
namespace {

constexpr double at_all_powers = std::numeric_limits<double>::infinity();

struct PowerPairs {
  std::vector<double> x, y;
};

StraightLine straight_line(const PowerPairs& points) {
  const auto n = static_cast<double>(points.x.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    mean_x += points.x[k] / n;
    mean_y += points.y[k] / n;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    const double dx = points.x[k] - mean_x;
    xx += dx * dx;
    xy += dx * (points.y[k] - mean_y);
  }
  if (!(xx > 1e-24 * n * mean_x * mean_x)) return {};  // one power
  StraightLine line{.slope = xy / xx};
  line.offset = mean_y - line.slope * mean_x;
  if (points.x.size() < 3) return line;
  double left = 0.0;
  for (std::size_t k = 0; k < points.x.size(); ++k)
    left += std::pow(points.y[k] - line(points.x[k]), 2);
  const double variance = left / (n - 2.0);
  line.slope_std = std::sqrt(variance / xx);
  line.offset_std = std::sqrt(variance * (1.0 / n + mean_x * mean_x / xx));
  return line;
}

PowerLaw power_law(const PowerPairs& points) {
  PowerPairs logarithms;
  const double sign = points.y.front() < 0.0 ? -1.0 : 1.0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    if (!(points.x[k] > 0.0) || !(sign * points.y[k] > 0.0)) return {};
    logarithms.x.push_back(std::log(points.x[k]));
    logarithms.y.push_back(std::log(sign * points.y[k]));
  }
  const StraightLine line = straight_line(logarithms);
  PowerLaw law{.factor = sign * std::exp(line.offset),
               .exponent = line.slope,
               .exponent_std = line.slope_std};
  double left = 0.0;
  for (std::size_t k = 0; k < points.x.size(); ++k)
    left += std::pow(law(points.x[k]) / points.y[k] - 1.0, 2);
  law.rms = std::sqrt(left / static_cast<double>(points.x.size()));
  return law;
}

/// Narrows a range of P to where a line has the sign of `inside`.
void narrow_validity(const StraightLine& line, double inside, double& from, double& to) {
  if (std::isnan(line.slope) || line.slope == 0.0) return;
  const double root = -line.offset / line.slope;
  // It leaves that sign below the root where it moves away from zero with P, else above.
  if (line.slope * inside > 0.0)
    from = std::max(from, root);
  else
    to = std::min(to, root);
}

double sum_of_values(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

/// Points of one power as their mean, rising.
PowerPairs merged_points(std::span<const LagAt> points, double LagAt::*value) {
  std::map<double, std::pair<double, int>> sums;
  for (const LagAt& p : points) {
    auto& [sum, count] = sums[p.input];
    sum += p.*value;
    ++count;
  }
  PowerPairs result;
  for (const auto& [power, of] : sums) {
    result.x.push_back(power);
    result.y.push_back(of.first / of.second);
  }
  return result;
}

/// Through these points and this value at 0.
MonotoneCurve curve_through(PowerPairs p, double at_zero) {
  const auto place = std::lower_bound(p.x.begin(), p.x.end(), 0.0);
  const auto at = place - p.x.begin();
  if (place != p.x.end() && *place == 0.0) {
    p.y[static_cast<std::size_t>(at)] = at_zero;
  } else {
    p.x.insert(place, 0.0);
    p.y.insert(p.y.begin() + at, at_zero);
  }
  return {std::move(p.x), std::move(p.y)};
}

/// At an end, from the two secants next to it: three points of a parabola, but no turn that the
/// points do not make.
double end_slope(double near, double far, double near_width, double far_width) {
  const double slope =
      ((2.0 * near_width + far_width) * near - near_width * far) / (near_width + far_width);
  if (slope * near <= 0.0) return 0.0;
  if (near * far < 0.0 && std::abs(slope) > 3.0 * std::abs(near)) return 3.0 * near;
  return slope;
}

}  // namespace

double PowerLaw::operator()(double power) const { return factor * std::pow(power, exponent); }

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size(), 0.0) {
  if (x_.empty() || x_.size() != y_.size())
    throw std::invalid_argument("a curve needs one value for each point, and at least one point");
  if (std::adjacent_find(x_.begin(), x_.end(), std::greater_equal<>()) != x_.end())
    throw std::invalid_argument(
        "the points of a curve must be in ascending order, without duplicates");
  const std::size_t n = x_.size();
  if (n < 2) return;
  std::vector<double> width, secant;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    width.push_back(x_[k + 1] - x_[k]);
    secant.push_back((y_[k + 1] - y_[k]) / width[k]);
  }
  if (n == 2) {
    slope_.assign(2, secant[0]);
    return;
  }
  // Within: the harmonic mean of the secants, weighted by their widths; flat where the points turn.
  for (std::size_t k = 1; k + 1 < n; ++k) {
    if (secant[k - 1] * secant[k] <= 0.0) continue;
    const double before = width[k - 1] + 2.0 * width[k], after = 2.0 * width[k - 1] + width[k];
    slope_[k] = (before + after) / (before / secant[k - 1] + after / secant[k]);
  }
  slope_.front() = end_slope(secant[0], secant[1], width[0], width[1]);
  slope_.back() = end_slope(secant[n - 2], secant[n - 3], width[n - 2], width[n - 3]);
}

double MonotoneCurve::operator()(double x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const auto k =
      static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
  const double width = x_[k + 1] - x_[k], s = (x - x_[k]) / width;
  const double rest = 1.0 - s;
  return rest * rest * (1.0 + 2.0 * s) * y_[k] + s * s * (1.0 + 2.0 * rest) * y_[k + 1] +
         width * s * rest * (rest * slope_[k] - s * slope_[k + 1]);
}

PowerLaws fit_power_laws(std::span<const LagAt> points) {
  for (const LagAt& p : points) {
    if (!(p.input >= 0.0) || !std::isfinite(p.input))
      throw std::invalid_argument(fmt::format("power = {} W: must be 0 W or more", p.input));
    if (!std::isfinite(p.gain) || !std::isfinite(p.time_constant))
      throw std::invalid_argument(fmt::format(
          "the step response at {} W has no finite gain or no finite time constant", p.input));
  }
  return fit_load_laws(points);
}

PowerLaws fit_load_laws(std::span<const LagAt> points) {
  PowerPairs gain, time;
  for (const LagAt& p : points) {
    gain.x.push_back(p.input);
    gain.y.push_back(p.gain);
    time.x.push_back(p.input);
    time.y.push_back(p.time_constant);
  }
  PowerLaws laws;
  if (points.size() < 2) return laws;
  laws.gain_line = straight_line(gain);
  laws.time_line = straight_line(time);
  if (std::isnan(laws.gain_line.slope)) return laws;
  laws.gain_power = power_law(gain);
  laws.time_power = power_law(time);
  laws.valid_from = 0.0;
  laws.valid_to = at_all_powers;
  narrow_validity(laws.gain_line, sum_of_values(gain.y), laws.valid_from, laws.valid_to);
  narrow_validity(laws.time_line, 1.0, laws.valid_from, laws.valid_to);
  return laws;
}

MonotoneCurve gain_curve(std::span<const LagAt> points) {
  return curve_through(merged_points(points, &LagAt::gain), 0.0);
}

MonotoneCurve time_curve(std::span<const LagAt> points, double at_rest) {
  PowerPairs p = merged_points(points, &LagAt::time_constant);
  const bool known = std::find(p.x.begin(), p.x.end(), 0.0) != p.x.end();
  if (known || std::isnan(at_rest)) return {std::move(p.x), std::move(p.y)};
  return curve_through(std::move(p), at_rest);
}

}  // namespace raceway::spindle
