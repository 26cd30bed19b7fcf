#include "tolerance/thinned_record.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "record/series_channel.h"

namespace raceway::tolerance {
namespace {

using record::Channel;
using record::Record;
using record::Role;

constexpr std::size_t few_enough = 20000;
constexpr double pieces = 8000.0;

/// Rows from `first` to before `last` that become one.
struct Stretch {
  std::size_t first, last;
};

std::vector<Stretch> stretches_of(const record::Record& record) {
  const std::span<const double> time = record.values(record::time);
  const record::Channel* const setup = record::series_channel("setup_id");
  const auto is_other = [&](std::size_t a, std::size_t b) {
    return record.run_of(a) != record.run_of(b) ||
           (record.has(*setup) && record.value(*setup, a) != record.value(*setup, b));
  };
  double whole = 0.0;
  for (std::size_t k = 1; k < time.size(); ++k)
    if (!is_other(k, k - 1)) whole += time[k] - time[k - 1];
  const double width = whole / pieces;
  std::vector<Stretch> list;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (list.empty() || is_other(k, k - 1) || time[k] - time[list.back().first] >= width)
      list.push_back({k, k});
    list.back().last = k + 1;
  }
  return list;
}

/// Of what there is.
double mean(std::span<const double> values, const Stretch& s) {
  double sum = 0.0, count = 0.0;
  for (std::size_t k = s.first; k < s.last; ++k)
    if (std::isfinite(values[k])) sum += values[k], count += 1.0;
  return count > 0.0 ? sum / count : unset;
}

/// Of what holds from each row until the next, from one mean time to the next one; `held`: its
/// integral up to every row.
std::vector<double> means_until_next(const record::Record& record, std::span<const double> values,
                                     const std::vector<Stretch>& stretches,
                                     const std::vector<double>& at) {
  const std::span<const double> time = record.values(record::time);
  std::vector<double> held(values.size(), 0.0);
  for (std::size_t k = 1; k < values.size(); ++k)
    held[k] = held[k - 1] + values[k - 1] * (time[k] - time[k - 1]);
  const auto integral = [&](double t, const Stretch& within) {
    std::size_t k = within.first;
    while (k + 1 < within.last && time[k + 1] <= t) ++k;
    return held[k] + values[k] * (t - time[k]);
  };
  std::vector<double> list;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const bool ends = i + 1 == stretches.size() || !(at[i + 1] > at[i]) ||
                      record.run_of(stretches[i + 1].first) != record.run_of(stretches[i].first);
    list.push_back(ends ? values[stretches[i].last - 1]
                        : (integral(at[i + 1], stretches[i + 1]) - integral(at[i], stretches[i])) /
                              (at[i + 1] - at[i]));
  }
  return list;
}

}  // namespace

std::shared_ptr<const record::Record> for_search(std::shared_ptr<const record::Record> record) {
  if (record->rows() <= few_enough || !record->has(record::time)) return record;
  const std::vector<Stretch> stretches = stretches_of(*record);
  if (2 * stretches.size() > record->rows()) return record;
  auto thin = std::make_shared<record::Record>(record->without_rows());
  for (record::Column& c : thin->columns) c.values.assign(stretches.size(), unset);
  std::vector<double> at;
  for (const Stretch& s : stretches) at.push_back(mean(record->values(record::time), s));
  thin->lines.clear();
  for (const Stretch& s : stretches) thin->lines.push_back(record->line(s.first));
  for (const record::Column& c : record->columns) {
    const record::Channel& channel = *c.channel;
    std::vector<double>& out = thin->find(channel)->values;
    const bool of_rows = channel.role == Role::run || channel.role == Role::part;
    const bool held = channel.is_input() && record::course_of(channel) == record::Course::held;
    if (held && !of_rows) {
      out = means_until_next(*record, c.values, stretches, at);
      continue;
    }
    for (std::size_t i = 0; i < stretches.size(); ++i)
      out[i] = of_rows ? c.values[stretches[i].first] : mean(c.values, stretches[i]);
  }
  return thin;
}

}  // namespace raceway::tolerance
