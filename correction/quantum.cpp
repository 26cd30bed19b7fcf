#include "correction/quantum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>

#include "record/median.h"
#include "record/units.h"

namespace raceway::correction {

double quantum_of(const record::Channel& channel, std::span<const double> values) {
  constexpr std::size_t few_values = 2000;
  std::set<double> levels;
  for (const double v : values) {
    if (std::isfinite(v)) levels.insert(channel.in_unit(v));
    if (levels.size() > few_values) return unset;
  }
  if (levels.size() < 3) return unset;
  double least = std::numeric_limits<double>::infinity();
  for (auto a = levels.begin(), b = std::next(a); b != levels.end(); ++a, ++b)
    if (*b - *a > 1e-9) least = std::min(least, *b - *a);
  constexpr double off_the_lattice = 0.02;
  for (const double v : levels) {
    const double steps = (v - *levels.begin()) / least;
    if (std::abs(steps - std::round(steps)) > off_the_lattice) return unset;
  }
  return least * channel.factor;
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

Still longest_still(const record::Record& record, std::span<const double> values) {
  const std::span<const double> time = record.values(record::time);
  const auto begins = [&](std::size_t row) { return record.run_of(row) != record.run_of(row - 1); };
  std::vector<double> steps;
  for (std::size_t row = 1; row < time.size(); ++row)
    if (!begins(row)) steps.push_back(time[row] - time[row - 1]);
  const double longest_step = a_gap * record::median(steps);
  Still found;
  for (std::size_t row = 1, since = 0; row < values.size(); ++row) {
    if (begins(row) || time[row] - time[row - 1] > longest_step || values[row] != values[row - 1])
      since = row;
    if (time[row] - time[since] > found.longest) found = {time[row] - time[since], time[since]};
  }
  return found;
}

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
