#include "files/detail/filled_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "record/median.h"
#include "record/series_channel.h"

namespace raceway::files {
namespace {

/// RunRows of one run, [begin, end).
struct RunRows {
  std::size_t begin, end;
};

std::vector<RunRows> runs_of(const record::Record& data) {
  std::vector<RunRows> list;
  for (std::size_t row = 0; row < data.rows(); ++row) {
    if (row == 0 || data.run_of(row) != data.run_of(row - 1)) list.push_back({row, row});
    list.back().end = row + 1;
  }
  return list;
}

void hold(std::vector<double>& values, const RunRows& run) {
  for (std::size_t row = run.begin + 1; row < run.end; ++row)
    if (std::isnan(values[row])) values[row] = values[row - 1];
}

/// [s]; of all runs together.
double usual_interval(const std::vector<double>& values, std::span<const double> time,
                      const std::vector<RunRows>& runs) {
  std::vector<double> intervals;
  for (const RunRows& run : runs) {
    std::optional<std::size_t> last;
    for (std::size_t row = run.begin; row < run.end; ++row) {
      if (std::isnan(values[row])) continue;
      if (last) intervals.push_back(time[row] - time[*last]);
      last = row;
    }
  }
  return record::median(intervals);
}

/// Rows in longer gaps than that go to `far`.
void interpolate(std::vector<double>& values, std::span<const double> time, const RunRows& run,
                 double longest, std::vector<std::size_t>& far) {
  std::optional<std::size_t> last;
  const auto fill = [&](std::size_t from, std::size_t to, double gap, const auto& value) {
    for (std::size_t row = from; row < to; ++row) {
      values[row] = value(row);
      if (!(gap <= longest)) far.push_back(row);
    }
  };
  for (std::size_t row = run.begin; row < run.end; ++row) {
    if (std::isnan(values[row])) continue;
    const std::size_t before = last ? *last : run.begin;
    const double gap = time[row] - time[before];
    if (!last) {
      fill(run.begin, row, gap, [&](std::size_t) { return values[row]; });
    } else {
      const double from = values[before], slope = (values[row] - from) / gap;
      fill(before + 1, row, gap,
           [&](std::size_t at) { return from + slope * (time[at] - time[before]); });
    }
    last = row;
  }
  const std::size_t end = last ? *last + 1 : run.begin;
  const double value = last ? values[*last] : unset;
  fill(end, run.end, last ? time[run.end - 1] - time[*last] : unset,
       [&](std::size_t) { return value; });
}

}  // namespace

FilledInput fill_input(const record::Channel& channel, record::Record& data) {
  constexpr double intervals = 10.0, shortest_limit = 300.0;  // [1], [s]
  std::vector<double>& values = data.find(channel)->values;
  const auto empty = [](double v) { return std::isnan(v); };
  const auto missing = std::count_if(values.begin(), values.end(), empty);
  FilledInput result;
  if (missing == 0) return result;
  const std::span<const double> time = data.values(record::time);
  const std::vector<RunRows> runs = runs_of(data);
  const bool held = record::course_of(channel) == record::Course::held;
  const double longest = std::fmax(intervals * usual_interval(values, time, runs), shortest_limit);
  for (const RunRows& run : runs)
    held ? hold(values, run) : interpolate(values, time, run, longest, result.far);
  if (!held) result.longest = longest;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (empty(values[row])) result.empty.push_back(row);
  result.note = fmt::format("{} of {} rows have no {}: {}", missing, values.size(), channel.name,
                            held ? "the last value is used until the next one"
                                 : fmt::format("values are interpolated linearly between readings, "
                                               "over gaps of up to {:.4g} s",
                                               longest));
  return result;
}

}  // namespace raceway::files
