#include "correction/quantum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "record/units.h"

namespace raceway::correction {

double quantum_of(std::span<const double> values) {
  constexpr double rounding = 1e-6, off_lattice = 0.01;  // of a unit; of the quantum
  std::vector<double> levels(values.begin(), values.end());
  std::sort(levels.begin(), levels.end());
  const auto same = [](double a, double b) { return b - a < rounding; };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  double least = unset;
  for (std::size_t k = 1; k < levels.size(); ++k)
    least = std::fmin(least, levels[k] - levels[k - 1]);
  for (const double level : levels) {
    const double steps = (level - levels.front()) / least;
    if (!(std::abs(steps - std::round(steps)) < off_lattice)) return unset;
  }
  return least;
}

namespace {

struct Point {
  double time, value;
};

/// Points through which a run of rows may have gone.
std::vector<Point> points_of(std::span<const double> time, std::span<const double> values) {
  std::vector<Point> points;
  std::vector<std::size_t> changes;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (values[k] != values[k - 1]) changes.push_back(k);
  if (changes.empty()) return {{time.front(), values.front()}};
  const auto half_way = [&](std::size_t k) {
    return Point{0.5 * (time[k - 1] + time[k]), 0.5 * (values[k - 1] + values[k])};
  };
  points.push_back({time.front(), values.front()});
  for (std::size_t c = 0; c < changes.size(); ++c) {
    points.push_back(half_way(changes[c]));
    if (c + 1 == changes.size()) break;
    const double here = values[changes[c]];
    const bool turns = (here > values[changes[c] - 1]) == (here > values[changes[c + 1]]);
    if (turns) points.push_back({0.5 * (time[changes[c]] + time[changes[c + 1] - 1]), here});
  }
  if (time.back() > points.back().time) points.push_back({time.back(), values.back()});
  return points;
}

}  // namespace

std::vector<double> between_digits(std::span<const double> time, std::span<const double> values,
                                   const std::vector<bool>& begins) {
  std::vector<double> result(values.size());
  for (std::size_t first = 0; first < values.size();) {
    std::size_t last = first + 1;
    while (last < values.size() && !begins[last]) ++last;
    const std::vector<Point> points =
        points_of(time.subspan(first, last - first), values.subspan(first, last - first));
    std::size_t p = 0;
    for (std::size_t k = first; k < last; ++k) {
      while (p + 1 < points.size() && points[p + 1].time <= time[k]) ++p;
      const Point &a = points[p], &b = points[std::min(p + 1, points.size() - 1)];
      const double share = b.time > a.time ? (time[k] - a.time) / (b.time - a.time) : 0.0;
      result[k] = a.value + share * (b.value - a.value);
    }
    first = last;
  }
  return result;
}

}  // namespace raceway::correction
