#include "fit/noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "record/median.h"
#include "record/repeats.h"

namespace raceway::fit {

namespace {

constexpr int fewest_degrees_of_noise = 3;

/// Rows at which the channel was read.
std::vector<std::size_t> read_rows(std::span<const double> readings) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (std::isfinite(readings[i])) rows.push_back(i);
  return rows;
}

}  // namespace

std::string_view name(NoiseSource source) {
  switch (source) {
    case NoiseSource::none:
      return "none";
    case NoiseSource::declared:
      return "declared";
    case NoiseSource::regression:
      return "regression";
    case NoiseSource::repeats:
      return "repeats";
    case NoiseSource::neighbours:
      return "neighbours";
  }
  return "none";
}

Noise estimate_noise(const record::Record& record, const record::Channel& measured) {
  Noise noise;
  const std::span<const double> readings = record.values(measured);
  const std::vector<std::size_t> rows = read_rows(readings);
  if (rows.empty()) return noise;
  double square = 0.0;
  for (const record::RepeatGroup& group : record::find_repeats(record, {}, rows)) {
    double mean = 0.0;
    for (const std::size_t i : group) mean += readings[i];
    mean /= static_cast<double>(group.size());
    for (const std::size_t i : group) square += (readings[i] - mean) * (readings[i] - mean);
    noise.degrees_of_freedom += static_cast<int>(group.size()) - 1;
  }
  if (noise.degrees_of_freedom > 0)
    noise.repeats_rms = std::sqrt(square / noise.degrees_of_freedom);

  const record::Column* const std = record.deviation_of(measured);
  double sum = 0.0;
  bool all = std != nullptr;
  for (const std::size_t i : rows) {
    if (!all) break;
    all = std->values[i] > 0.0 && std::isfinite(std->values[i]);
    sum += std->values[i] * std->values[i];
  }
  if (all) {
    noise.rms = std::sqrt(sum / static_cast<double>(rows.size()));
    noise.source = std->known ? NoiseSource::regression : NoiseSource::declared;
  } else if (noise.degrees_of_freedom >= fewest_degrees_of_noise && noise.repeats_rms > 0.0) {
    noise.rms = noise.repeats_rms;
    noise.source = NoiseSource::repeats;
  }
  return noise;
}

namespace {

/// Distance of each reading from the line between its neighbours, over that of one of unit noise.
struct SecondDifferences {
  std::vector<double> steps{}, sizes{};
};

SecondDifferences second_differences(const record::Record& record,
                                     const record::Channel& measured) {
  const std::span<const double> time = record.values(record::time), read = record.values(measured);
  const std::vector<std::size_t> rows = read_rows(read);
  SecondDifferences found;
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const std::size_t a = rows[i - 2], b = rows[i - 1], c = rows[i];
    if (record.run_of(a) != record.run_of(c)) continue;
    found.steps.push_back(time[c] - time[b]);
    const double share = (time[b] - time[a]) / (time[c] - time[a]);
    const double between = (1.0 - share) * read[a] + share * read[c];
    found.sizes.push_back(std::abs(read[b] - between) /
                          std::sqrt(1.0 + (1.0 - share) * (1.0 - share) + share * share));
  }
  return found;
}

/// Sum of squares of readings about their mean, or about a line through 4 or more.
struct StopScatter {
  double mean = 0.0, squares = 0.0;
  int degrees_of_freedom = 0;
};

StopScatter scatter_in_stop(std::span<const std::size_t> rows, std::span<const double> time,
                            std::span<const double> read) {
  constexpr std::size_t fewest_for_a_line = 4;
  const auto n = static_cast<double>(rows.size());
  StopScatter s{.degrees_of_freedom = static_cast<int>(rows.size()) - 1};
  double middle = 0.0;
  for (const std::size_t k : rows) s.mean += read[k] / n, middle += time[k] / n;
  double across = 0.0, along = 0.0;
  for (const std::size_t k : rows) {
    s.squares += std::pow(read[k] - s.mean, 2);
    across += (read[k] - s.mean) * (time[k] - middle);
    along += std::pow(time[k] - middle, 2);
  }
  if (rows.size() < fewest_for_a_line || !(along > 0.0)) return s;
  s.squares = std::max(0.0, s.squares - across * across / along);
  --s.degrees_of_freedom;
  return s;
}

/// Readings of one run in groups, with breaks longer than `longest_step` between them.
std::vector<std::vector<std::size_t>> groups_of(const record::Record& record,
                                                const std::vector<std::size_t>& rows,
                                                double longest_step) {
  const std::span<const double> time = record.values(record::time);
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t k : rows) {
    if (groups.empty() || record.run_of(groups.back().back()) != record.run_of(k) ||
        time[k] - time[groups.back().back()] > longest_step)
      groups.emplace_back();
    groups.back().push_back(k);
  }
  return groups;
}

}  // namespace

Repeatability repeatability(const record::Record& record, const record::Channel& measured) {
  constexpr double far_longer = 3.0, longest_stop_step = 120.0;  // [1], [s]
  constexpr std::size_t most_in_a_stop = 30, fewest_stops = 2;
  const std::span<const double> time = record.values(record::time), read = record.values(measured);
  const std::vector<std::size_t> rows = read_rows(read);
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (record.run_of(rows[i]) == record.run_of(rows[i - 1]))
      steps.push_back(time[rows[i]] - time[rows[i - 1]]);
  if (steps.size() < fewest_stops) return {};
  // Of pairs in stops half of the steps are short.
  const auto quarter = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 4);
  std::nth_element(steps.begin(), quarter, steps.end());
  const double within = std::min(far_longer * *quarter, longest_stop_step);
  Repeatability found;
  double squares = 0.0;
  std::size_t repeated = 0, gathered = 0;
  for (const std::vector<std::size_t>& group : groups_of(record, rows, within)) {
    if (group.size() > most_in_a_stop) return {};
    const StopScatter s = scatter_in_stop(group, time, read);
    found.stops.push_back(
        {.time = time[group.front()],
         .readings = static_cast<int>(group.size()),
         .mean = s.mean,
         .std = s.degrees_of_freedom > 0 ? std::sqrt(s.squares / s.degrees_of_freedom) : unset});
    if (group.size() < 2) continue;
    squares += s.squares;
    found.degrees_of_freedom += s.degrees_of_freedom;
    gathered += group.size();
    ++repeated;
  }
  // A few readings that happen to stand close are no habit.
  if (repeated < fewest_stops || 2 * gathered < rows.size() ||
      found.degrees_of_freedom < fewest_degrees_of_noise)
    return {};
  found.std = std::sqrt(squares / found.degrees_of_freedom);
  return found;
}

double noise_of_neighbours(const record::Record& record, const record::Channel& measured) {
  constexpr double far_apart = 120.0;  // [s]
  constexpr double to_std = 1.4826;    // of a median distance, for a normal law
  if (const Repeatability in_stops = repeatability(record, measured);
      in_stops.known() && in_stops.std > 0.0)
    return in_stops.std;
  const SecondDifferences second = second_differences(record, measured);
  if (second.sizes.size() < 30 || record::median(second.steps) > far_apart) return unset;
  return to_std * record::median(second.sizes);
}

double noise_of_calm_readings(const record::Record& record, const record::Channel& measured) {
  constexpr double lower_quartile = 0.31864;  // of the amount of a normal variable
  constexpr std::size_t fewest = 10;
  std::vector<double> sizes = second_differences(record, measured).sizes;
  if (sizes.size() < fewest) return unset;
  const auto quarter = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 4);
  std::nth_element(sizes.begin(), quarter, sizes.end());
  return *quarter / lower_quartile;
}

}  // namespace raceway::fit
