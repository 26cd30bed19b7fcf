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

double noise_of_neighbours(const record::Record& record, const record::Channel& measured) {
  constexpr double far_apart = 120.0;  // [s]
  constexpr double to_std = 1.4826;    // of a median distance, for a normal law
  const std::span<const double> time = record.values(record::time), read = record.values(measured);
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < read.size(); ++k)
    if (std::isfinite(read[k])) rows.push_back(k);
  std::vector<double> steps, second;
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const std::size_t a = rows[i - 2], b = rows[i - 1], c = rows[i];
    if (record.run_of(a) != record.run_of(c)) continue;
    steps.push_back(time[c] - time[b]);
    const double share = (time[b] - time[a]) / (time[c] - time[a]);
    const double between = (1.0 - share) * read[a] + share * read[c];
    second.push_back(std::abs(read[b] - between) /
                     std::sqrt(1.0 + (1.0 - share) * (1.0 - share) + share * share));
  }
  if (second.size() < 30 || record::median(steps) > far_apart) return unset;
  return to_std * record::median(second);
}

}  // namespace raceway::fit
