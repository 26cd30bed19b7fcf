#include "model/torque_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "model/row.h"

namespace raceway::model {

std::vector<double> logarithm(std::vector<double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::fmax(largest, std::abs(v));
  const double floor = largest > 0.0 ? 1e-2 * largest : 1.0;
  for (double& v : values) v = std::log(std::isnan(v) ? v : std::max(std::abs(v), floor));
  return values;
}

fit::Saturation torque_saturation(const record::Record& record, TorqueLoad load,
                                  std::vector<TorqueLoad> further) {
  fit::Saturation s{.levels_before_candidates = true, .proportional = true};
  std::vector<double> speeds, temperatures;
  for (const Row& row : rows_of(record)) {
    speeds.push_back(row.point.speed);
    temperatures.push_back(row.point.temperature);
  }
  s.levels = {&record::speed, load.channel};
  s.surface.inputs = {
      {logarithm(std::move(speeds)), 1e-3}, std::move(load.input), {std::move(temperatures), 0.5}};
  // Exponents of speed, the load and temperature.
  std::vector<std::vector<int>> terms{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0},
                                      {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1},
                                      {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {2, 0, 1}};
  // Whatever else varies may be what the torque depends on.
  for (const record::Channel* channel :
       {&record::preload, &record::inner_ring_temperature, &record::outer_ring_temperature}) {
    if (!record.complete(*channel) || !record.varies(*channel)) continue;
    const std::span<const double> column = record.values(*channel);
    std::vector<double> values(column.begin(), column.end());
    const bool force = *channel == record::preload;
    if (force) values = logarithm(std::move(values));
    further.push_back({channel, {std::move(values), force ? 1e-3 : 0.5}});
  }
  for (TorqueLoad& other : further) {
    s.surface.inputs.push_back(std::move(other.input));
    for (std::vector<int>& term : terms) term.push_back(0);
    std::vector<int> exponents(s.surface.inputs.size(), 0);
    for (const auto& [speed, first, own] : {std::array{0, 0, 1}, {0, 0, 2}, {1, 0, 1}, {0, 1, 1}}) {
      exponents[0] = speed;
      exponents[1] = first;
      exponents.back() = own;
      terms.push_back(exponents);
    }
    if (other.channel->role == record::Role::setting) s.levels.push_back(other.channel);
  }
  s.surface.terms = std::move(terms);
  return s;
}

std::vector<const record::Channel*> scattering_temperature(const record::Record& record) {
  if (!record.varies(record::temperature)) return {};
  return {&record::temperature};
}

}  // namespace raceway::model
