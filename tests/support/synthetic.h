#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "model/model.h"
#include "model/prediction.h"
#include "tests/support/rows.h"

namespace raceway::fit {

/// A spindle bearing of bore 70 mm on a rig, grease of 22 mm²/s.
inline Model synthetic_model() {
  const bearing::BearingGeometry geometry{.ball_count = 20,
                                          .ball_diameter = 11.906 * mm,
                                          .pitch_diameter = 90.0 * mm,
                                          .contact_angle = 25.0 * degree,
                                          .inner_conformity = 0.52,
                                          .outer_conformity = 0.52,
                                          .static_load_rating = 43000.0};
  return {.name = "7014",
          .bearing = bearing::Bearing(geometry, bearing::steel(), bearing::steel()),
          .lubricant = friction::Lubricant(22.0 * mm2_per_s, 4.8 * mm2_per_s),
          .law = friction::FrictionLaw::palmgren,
          .law_values = {1.5, 0.001, 0.33},
          .effects = {},
          .solver = {},
          .rig = {},
          .free = {}};
}

/// The synthetic model with the contact law and the initial values of its parameters.
inline Model contact_model() {
  Model model = synthetic_model();
  model.law = friction::FrictionLaw::contact;
  model.law_values.clear();
  for (const friction::Parameter& p : friction::parameters(model.law))
    model.law_values.push_back(p.initial);
  return model;
}

/// Every combination of speed, load and temperature, as a rig would be driven.
inline DataSet factorial_plan(const std::vector<double>& speeds_rpm,
                              const std::vector<double>& axial_loads,
                              const std::vector<double>& temperatures_C, int repeats = 1) {
  DataSet data;
  data.source = "synthetic.csv";
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (const double temperature : temperatures_C)
      for (const double load : axial_loads)
        for (const double speed : speeds_rpm) {
          Row row;
          row.point.speed = speed * rpm;
          row.point.axial_load = load;
          row.point.temperature = kelvin(temperature);
          row.line = static_cast<int>(data.rows.size()) + 2;
          data.rows.push_back(row);
        }
  return data;
}

/// Fills in readings: the torque of the model and Gaussian noise [N m].
inline void measure(const Model& model, double noise, std::mt19937& random, DataSet& data) {
  std::normal_distribution<double> gauss;
  const std::vector<FrictionPrediction> predictions = predict_rows(model, data);
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    data.rows[i].measured = predictions[i].reading + noise * gauss(random);
}

inline void declare_noise(double std, DataSet& data) {
  data.noise = NoiseSource::declared;
  for (Row& row : data.rows) row.std = std;
}

}  // namespace raceway::fit
