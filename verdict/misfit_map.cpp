#include "verdict/misfit_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fit/distributions.h"

namespace raceway::verdict {
namespace {

constexpr double chance = 0.05;  // of any significant cell where nothing is wrong

std::vector<ErrorRange> ranges_of(const Comparison& comparison, const record::Channel& channel) {
  std::vector<ErrorRange> ranges;
  for (const ErrorRange& r : comparison.where)
    if (*r.channel == channel) ranges.push_back(r);
  std::sort(ranges.begin(), ranges.end(),
            [](const ErrorRange& a, const ErrorRange& b) { return a.from < b.from; });
  return ranges;
}

/// One range that holds every row.
ErrorRange all_rows(const Comparison& comparison, const record::Record& record,
                    const record::Channel& channel) {
  ErrorRange range{.channel = &channel, .rows = comparison.rows};
  range.from = std::numeric_limits<double>::infinity();
  range.to = -range.from;
  for (const RowError& e : comparison.errors) {
    const double value = record.value(channel, e.row);
    range.from = std::fmin(range.from, value);
    range.to = std::fmax(range.to, value);
  }
  range.rmse = comparison.rmse;
  range.bias = comparison.bias;
  return range;
}

/// What may stand upwards: settings on a ratio scale, then all other inputs, then runs.
std::vector<const record::Channel*> upwards(const record::Record& record,
                                            const record::Channel* across) {
  std::vector<const record::Channel*> list;
  const auto add = [&](auto wanted) {
    for (const record::Column& c : record.columns)
      if (c.channel != across && wanted(*c.channel)) list.push_back(c.channel);
  };
  const auto first = [](const record::Channel& c) {
    return c.role == record::Role::setting && c.ratio;
  };
  add(first);
  add([&](const record::Channel& c) { return c.is_input() && !first(c); });
  add([](const record::Channel& c) { return c.role == record::Role::run; });
  return list;
}

/// The last range that begins at or below the value: ranges do not overlap and hold every row that
/// was read.
std::size_t place(const std::vector<ErrorRange>& ranges, double value) {
  const auto above =
      std::upper_bound(ranges.begin(), ranges.end(), value,
                       [](double v, const ErrorRange& range) { return v < range.from; });
  return above == ranges.begin() ? 0 : static_cast<std::size_t>(above - ranges.begin()) - 1;
}

}  // namespace

MisfitMap misfit_map(const Comparison& comparison, const record::Record& record,
                     std::span<const double> std) {
  MisfitMap map;
  map.across_channel = comparison.pattern.along;
  if (!map.across_channel) return map;
  const record::Channel& across = *map.across_channel;
  map.across = ranges_of(comparison, across);
  if (map.across.empty()) map.across = {all_rows(comparison, record, across)};
  for (const record::Channel* channel : upwards(record, map.across_channel)) {
    if (!map.up_channel) map.up_channel = channel;
    map.up = ranges_of(comparison, *channel);
    if (map.up.empty()) continue;
    map.up_channel = channel;
    break;
  }
  const record::Channel& up = map.up_channel ? *map.up_channel : across;
  if (map.up.empty()) map.up = {all_rows(comparison, record, up)};
  struct Sum {
    int rows = 0;
    double residual = 0.0, variance = 0.0;
  };
  std::vector<Sum> sums(map.across.size() * map.up.size());
  for (std::size_t i = 0; i < comparison.errors.size(); ++i) {
    const RowError& e = comparison.errors[i];
    const std::size_t x = place(map.across, record.value(across, e.row));
    const std::size_t y = place(map.up, record.value(up, e.row));
    Sum& sum = sums[y * map.across.size() + x];
    ++sum.rows;
    sum.residual += e.residual;
    sum.variance += std[i] * std[i];
  }
  const auto filled = std::count_if(sums.begin(), sums.end(), [](const Sum& s) { return s.rows; });
  map.needed_sigmas = fit::normal_exceeded_with(0.5 * chance / static_cast<double>(filled));
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const Sum& sum = sums[k];
    if (sum.rows == 0) continue;
    MisfitCell cell{.across = k % map.across.size(), .up = k / map.across.size(), .rows = sum.rows};
    cell.bias = sum.residual / sum.rows;
    cell.sigmas = sum.residual / std::sqrt(sum.variance);
    cell.significant = std::abs(cell.sigmas) > map.needed_sigmas;
    map.cells.push_back(cell);
  }
  return map;
}

}  // namespace raceway::verdict
