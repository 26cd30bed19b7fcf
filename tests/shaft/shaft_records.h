#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "shaft/displacement_rows.h"
#include "tests/support/shafts.h"

/// Measured displacement of a shaft of which the truth is known.
namespace raceway::fit {

using namespace shaft;

enum class ShaftPlan {
  sweep,         ///< 40 speeds to 10 000 rpm at the preload of the model, one temperature
  two_preloads,  ///< 30 speeds at 300 N, 30 at 900 N
  up_and_down    ///< at 300 N and 900 N up and down again in 15 steps each, rings warm up behind
};

/// Rows without readings.
inline DataSet shaft_plan(ShaftPlan plan) {
  DataSet data;
  data.source = "shaft.csv";
  data.quantity = Quantity::axial_displacement;
  const auto add = [&](double speed_rpm, double preload) -> Row& {
    Row row;
    row.point.speed = speed_rpm * rpm;
    row.point.axial_load = 0.0;
    row.preload = preload;
    row.line = static_cast<int>(data.rows.size()) + 2;
    data.rows.push_back(row);
    return data.rows.back();
  };
  if (plan == ShaftPlan::sweep)
    for (int i = 1; i <= 40; ++i) add(250.0 * i, unset);
  if (plan == ShaftPlan::two_preloads)
    for (const double preload : {300.0, 900.0})
      for (int i = 1; i <= 30; ++i) add(10000.0 * i / 30.0, preload);
  if (plan != ShaftPlan::up_and_down) return data;
  // The inner ring is 12 K and the outer ring 8 K warmer after hours at 10 000 rpm; it takes them
  // half an hour, of which every step has five minutes.
  constexpr double share = 1.0 / 6.0;
  for (const double preload : {300.0, 900.0}) {
    double inner = 0.0, outer = 0.0;
    const int run = static_cast<int>(data.runs.size());
    data.runs.push_back(std::to_string(run));
    for (int i = 1; i <= 30; ++i) {
      const double speed = 10000.0 / 15.0 * (i <= 15 ? i : 31 - i);
      const double heat = std::pow(speed / 10000.0, 1.5);
      inner += share * (12.0 * heat - inner);
      outer += share * (8.0 * heat - outer);
      Row& row = add(speed, preload);
      row.run = run;
      row.time = 300.0 * static_cast<double>(data.rows.size());
      row.inner_ring_temperature = kelvin(22.0 + inner);
      row.outer_ring_temperature = kelvin(22.0 + outer);
      row.point.temperature = kelvin(22.0 + outer);
    }
  }
  return data;
}

/// Readings of a shaft as `truth` says, with noise of variance absolute² + (relative u)²; the
/// standard deviations are declared where there is noise.
inline DataSet shaft_records(const Model& truth, ShaftPlan plan, double absolute = 0.0,
                             double relative = 0.0, std::uint64_t seed = 1) {
  DataSet data = shaft_plan(plan);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  const std::vector<double> u = predict_displacement(truth, data);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double sigma = std::hypot(absolute, relative * u[i]);
    data.rows[i].measured = u[i] + sigma * gauss(random);
    if (sigma > 0.0) data.rows[i].std = sigma;
  }
  if (absolute > 0.0) data.noise = NoiseSource::declared;
  return data;
}

/// The same with noise of `absolute` and 1 % of the reading, which nobody declares.
inline DataSet undeclared_records(const Model& truth, ShaftPlan plan, std::uint64_t seed,
                                  double absolute = 0.05 * um) {
  DataSet data = shaft_records(truth, plan, absolute, 0.01, seed);
  for (Row& row : data.rows) row.std = unset;
  data.noise = NoiseSource::none;
  return data;
}

}  // namespace raceway::fit
