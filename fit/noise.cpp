#include "fit/noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raceway::fit {

namespace {

constexpr int fewest_degrees = 3;

bool near(double a, double b, double relative, double absolute) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b)) + absolute;
}

bool same_point(const Row& a, const Row& b, const SamePoint& same) {
  const bearing::OperatingPoint& p = a.point;
  const bearing::OperatingPoint& q = b.point;
  // Loads are compared with the largest of them: a radial load of 0.01 N beside 1000 N is none.
  const double force = same.relative * std::max({std::abs(p.axial_load), std::abs(p.radial_load),
                                                 std::abs(q.axial_load), std::abs(q.radial_load)});
  return near(p.speed, q.speed, same.relative, 0.0) &&
         near(p.axial_load, q.axial_load, 0.0, force) &&
         near(p.radial_load, q.radial_load, 0.0, force) &&
         near(p.radial_load_z, q.radial_load_z, 0.0, force) &&
         near(p.moment_y, q.moment_y, same.relative, 0.0) &&
         near(p.moment_z, q.moment_z, same.relative, 0.0) &&
         near(p.temperature, q.temperature, 0.0, same.temperature) &&
         near(a.inner_ring_temperature, b.inner_ring_temperature, 0.0, same.temperature) &&
         near(a.outer_ring_temperature, b.outer_ring_temperature, 0.0, same.temperature) &&
         near(a.preload, b.preload, same.relative, 0.0);
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

std::vector<RepeatGroup> find_repeats(const DataSet& data, const SamePoint& same) {
  std::vector<std::size_t> order(data.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return data.rows[a].point.speed < data.rows[b].point.speed;
  });
  // Each row joins the first group whose first row it equals; only groups of nearly its speed
  // count.
  std::vector<RepeatGroup> groups;
  std::size_t oldest = 0;
  for (const std::size_t i : order) {
    const double speed = data.rows[i].point.speed;
    while (oldest < groups.size() &&
           !near(data.rows[groups[oldest].front()].point.speed, speed, same.relative, 0.0))
      ++oldest;
    std::size_t g = oldest;
    while (g < groups.size() && !same_point(data.rows[groups[g].front()], data.rows[i], same)) ++g;
    if (g == groups.size())
      groups.push_back({i});
    else
      groups[g].push_back(i);
  }
  std::erase_if(groups, [](const RepeatGroup& g) { return g.size() < 2; });
  return groups;
}

Noise estimate_noise(const DataSet& data) {
  Noise noise;
  double square = 0.0;
  for (const RepeatGroup& group : find_repeats(data)) {
    double mean = 0.0;
    for (const std::size_t i : group) mean += data.rows[i].measured;
    mean /= static_cast<double>(group.size());
    for (const std::size_t i : group) {
      const double deviation = data.rows[i].measured - mean;
      square += deviation * deviation;
    }
    noise.degrees_of_freedom += static_cast<int>(group.size()) - 1;
  }
  if (noise.degrees_of_freedom > 0)
    noise.repeats_rms = std::sqrt(square / noise.degrees_of_freedom);

  const bool all =
      !data.rows.empty() && std::all_of(data.rows.begin(), data.rows.end(), [](const Row& row) {
        return std::isfinite(row.std) && row.std > 0.0;
      });
  if (all) {
    double sum = 0.0;
    for (const Row& row : data.rows) sum += row.std * row.std;
    noise.rms = std::sqrt(sum / static_cast<double>(data.rows.size()));
    noise.source =
        data.noise == NoiseSource::regression ? NoiseSource::regression : NoiseSource::declared;
  } else if (noise.degrees_of_freedom >= fewest_degrees && noise.repeats_rms > 0.0) {
    noise.rms = noise.repeats_rms;
    noise.source = NoiseSource::repeats;
  }
  return noise;
}

}  // namespace raceway::fit
