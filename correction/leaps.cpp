#include "correction/leaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "record/median.h"

namespace raceway::correction {
namespace {

constexpr double ten_minutes = 600.0;
constexpr std::size_t fewest_readings = 3, most_readings = 20;
constexpr double of_median = 1.4826;  // standard deviation of what is normally distributed
constexpr double unusual = 5.0;
constexpr double longer_step = 2.0;  // a clock that jitters, or one missing row; beyond it a gap
constexpr std::size_t rows_of_one_speed = 3;

/// Where the straight line through readings [first, last) stands at a time.
double at(std::span<const double> time, std::span<const double> read, std::size_t first,
          std::size_t last, double when) {
  const auto count = static_cast<double>(last - first);
  double t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    t += (time[k] - when) / count;
    y += read[k] / count;
  }
  for (std::size_t k = first; k < last; ++k) {
    tt += std::pow(time[k] - when - t, 2);
    ty += (time[k] - when - t) * (read[k] - y);
  }
  return y - t * ty / tt;
}

struct Gap {
  double time = unset, size = unset;
};

/// Gaps between the readings of one run.
void look(std::span<const double> time, std::span<const double> read, std::vector<Gap>& gaps) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < time.size(); ++k) steps.push_back(time[k] - time[k - 1]);
  if (steps.size() < 2 * fewest_readings) return;
  const auto side = static_cast<std::size_t>(std::clamp(
      ten_minutes / record::median(steps), double{fewest_readings}, double{most_readings}));
  for (std::size_t k = side; k + side <= time.size(); ++k) {
    const double middle = 0.5 * (time[k - 1] + time[k]);
    const double gap = at(time, read, k, k + side, middle) - at(time, read, k - side, k, middle);
    if (std::isfinite(gap)) gaps.push_back({middle, std::abs(gap)});
  }
}

}  // namespace

std::vector<double> leaps(const record::Record& record, const record::Channel& displacement) {
  const std::span<const double> time = record.values(record::time),
                                speed = record.values(record::speed),
                                all = record.values(displacement);
  std::vector<double> changes;
  for (std::size_t k = 1; k < speed.size(); ++k)
    if (speed[k] != speed[k - 1]) changes.push_back(time[k]);
  std::sort(changes.begin(), changes.end());
  std::vector<Gap> gaps;
  std::vector<double> times, readings;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k > 0 && record.run_of(k) != record.run_of(k - 1)) {
      look(times, readings, gaps);
      times.clear();
      readings.clear();
    }
    if (std::isnan(all[k])) continue;
    times.push_back(time[k]);
    readings.push_back(all[k]);
  }
  look(times, readings, gaps);
  std::vector<double> quiet;
  const auto is_quiet = [&](const Gap& g) {
    const auto next = std::lower_bound(changes.begin(), changes.end(), g.time - ten_minutes);
    return next == changes.end() || *next > g.time + ten_minutes;
  };
  std::erase_if(gaps, [&](const Gap& g) { return !is_quiet(g); });
  for (const Gap& g : gaps) quiet.push_back(g.size);
  std::vector<double> found;
  if (quiet.empty()) return found;
  const double usual = of_median * record::median(quiet);
  for (const Gap& g : gaps)
    if (g.size > unusual * usual) found.push_back(g.time);
  return found;
}

std::vector<std::size_t> leaping_rows(const record::Record& record, const record::Channel& column,
                                      Leap least) {
  const std::span<const double> read = record.values(column), speed = record.values(record::speed);
  const std::span<const double> time = record.values(record::time);
  const auto step = [&](std::size_t k) { return time[k] - time[k - 1]; };
  const auto is_steady = [&](std::size_t k) {
    if (step(k) > longer_step * std::max(step(k - 1), step(k + 1))) return false;
    for (std::size_t j = k - 2; j <= k + 1; ++j)
      if (record.run_of(j) != record.run_of(k)) return false;
    for (std::size_t j = k > rows_of_one_speed ? k - rows_of_one_speed : 0; j <= k; ++j)
      if (!speed.empty() && speed[j] != speed[k]) return false;
    return true;
  };
  const auto rate = [&](std::size_t k) { return std::abs(read[k] - read[k - 1]) / step(k); };
  std::vector<std::size_t> rows;
  for (std::size_t k = 2; k + 1 < read.size(); ++k) {
    if (!is_steady(k)) continue;
    const double leap = std::abs(read[k] - read[k - 1]);
    const double beside = std::max(rate(k - 1), rate(k + 1)) * step(k);
    if (leap > least.size && leap > least.of_beside * beside) rows.push_back(k);
  }
  return rows;
}

}  // namespace raceway::correction
