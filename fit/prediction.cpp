#include "fit/prediction.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raceway::fit {

namespace {

constexpr std::size_t chunk = 32;  // points that share a warm start

bool finite(const bearing::OperatingPoint& p) {
  return std::isfinite(p.speed) && std::isfinite(p.axial_load) && std::isfinite(p.radial_load) &&
         std::isfinite(p.radial_load_z) && std::isfinite(p.moment_y) && std::isfinite(p.moment_z) &&
         std::isfinite(p.temperature);
}

/// `neighbour` is null for a cold start.
FrictionPrediction predict(const Model& model, const bearing::OperatingPoint& point, bool solve,
                           const bearing::BearingEquilibrium* neighbour) {
  FrictionPrediction result;
  result.effects.assign(model.effects.size(), unset);
  if (!finite(point)) {
    result.report.status = bearing::SolveStatus::not_finite;
    return result;
  }
  if (solve) {
    auto equilibrium = std::make_shared<const bearing::BearingEquilibrium>(
        neighbour
            ? bearing::solve_bearing_equilibrium(model.bearing, point, model.solver, *neighbour)
            : bearing::solve_bearing_equilibrium(model.bearing, point, model.solver));
    result.report = equilibrium->report;
    if (result.report.converged()) {
      result.equilibrium = std::move(equilibrium);
    } else if (needs_equilibrium(model)) {
      return result;
    }
  }
  const friction::BearingState<double> state =
      bearing_state(model, point, result.equilibrium.get());
  const friction::BaseMoments<double> base =
      friction::base_moments<double>(model.law, state, std::span<const double>(model.law_values));
  result.load = base.load;
  result.viscous = base.viscous;
  result.torque = base.load + base.viscous;
  for (std::size_t k = 0; k < model.effects.size(); ++k) {
    const effects::Effect& effect = model.effects[k];
    result.effects[k] = effect.description->moment(state, effect.values);
    result.torque += result.effects[k];
  }
  result.power_loss = result.torque * point.speed;
  return result;
}

}  // namespace

bool FrictionPrediction::predicted() const { return std::isfinite(torque); }

bool needs_equilibrium(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(), [](const effects::Effect& effect) {
    return effect.description->needs_equilibrium;
  });
}

FrictionPrediction predict_friction(const Model& model, const bearing::OperatingPoint& point,
                                    bool with_equilibrium) {
  return predict(model, point, with_equilibrium || needs_equilibrium(model), nullptr);
}

void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium) {
  if (points.size() != predictions.size())
    throw std::invalid_argument("predict_sweep: as many predictions as points are needed");
  const bool solve = with_equilibrium || needs_equilibrium(model);
  const std::size_t chunks = (points.size() + chunk - 1) / chunk;
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t k) {
    const bearing::BearingEquilibrium* neighbour = nullptr;
    for (std::size_t i = k * chunk; i < std::min((k + 1) * chunk, points.size()); ++i) {
      predictions[i] = predict(model, points[i], solve, neighbour);
      if (predictions[i].equilibrium) neighbour = predictions[i].equilibrium.get();
    }
  });
}

std::vector<FrictionPrediction> predict_rows(const Model& model, const DataSet& data) {
  std::vector<bearing::OperatingPoint> points;
  points.reserve(data.rows.size());
  for (const Row& row : data.rows) points.push_back(row.point);
  std::vector<FrictionPrediction> predictions(points.size());
  predict_sweep(model, points, predictions);
  return predictions;
}

double rig_torque(const Rig& rig, double bearing_torque) { return rig.bearings * bearing_torque; }

friction::BearingState<double> bearing_state(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium* equilibrium) {
  friction::BearingState<double> state;
  state.bearing = &model.bearing;
  state.equilibrium = equilibrium;
  state.race_control = model.solver.race_control;
  state.speed = point.speed;
  state.axial_load = point.axial_load;
  state.radial_load = std::hypot(point.radial_load, point.radial_load_z);
  state.temperature = point.temperature;
  state.kinematic_viscosity = model.lubricant.kinematic_viscosity(point.temperature);
  return state;
}

}  // namespace raceway::fit
