#include "fit/noise.h"

#include <cmath>
#include <vector>

#include "record/repeats.h"

namespace raceway::fit {

namespace {

constexpr int fewest_degrees = 3;

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
  } else if (noise.degrees_of_freedom >= fewest_degrees && noise.repeats_rms > 0.0) {
    noise.rms = noise.repeats_rms;
    noise.source = NoiseSource::repeats;
  }
  return noise;
}

}  // namespace raceway::fit
