#include "model/prediction.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/row.h"
#include "model/row_predictor.h"
#include "model/steps.h"

namespace raceway::model {
namespace {

constexpr std::size_t points_of_a_thread = 256;  // points that a thread takes

}  // namespace

bool FrictionPrediction::predicted() const { return std::isfinite(torque); }

bearing::SolveStatus FrictionPrediction::status() const {
  using bearing::SolveStatus;
  if (report.status != SolveStatus::not_run && !report.converged()) return report.status;
  const bool finite = std::isfinite(torque) && std::isfinite(load) && std::isfinite(viscous) &&
                      std::isfinite(power_loss) &&
                      std::all_of(effects.begin(), effects.end(),
                                  [](double moment) { return std::isfinite(moment); });
  return finite ? SolveStatus::converged : SolveStatus::not_finite;
}

std::string why_not_converged(const Model& model, const FrictionPrediction& prediction) {
  const bearing::SolveStatus status = prediction.status();
  // Without a moment of the base law nothing was computed: an effect lacks its input.
  if (status != bearing::SolveStatus::not_finite || !std::isfinite(prediction.load))
    return std::string(bearing::name(status));
  for (std::size_t k = 0; k < prediction.effects.size(); ++k)
    if (const double moment = prediction.effects[k]; !std::isfinite(moment)) {
      const effects::Description& effect = *model.effects[k].description;
      return fmt::format(
          "not_finite: the moment of effect {} is {}{}", effect.id,
          std::isnan(moment) ? "not a number" : "infinite",
          effect.user_made ? fmt::format(", torque_Nmm = \"{}\"", effect.formula) : std::string());
    }
  return std::string(bearing::name(status));
}

std::vector<std::string> torque_parts(const Model& model) {
  std::vector<std::string> names{"load", "viscous"};
  if (model.law == friction::FrictionLaw::contact)
    names = {"rolling", "sliding", "hysteresis", "drag"};
  if (model.law == friction::FrictionLaw::table) names = {"table"};
  for (const effects::Effect& e : model.effects) names.emplace_back(e.description->id);
  return names;
}

std::vector<double> moments_of_parts(const Model& model, const FrictionPrediction& p) {
  std::vector<double> moments{p.load, p.viscous};
  if (model.law == friction::FrictionLaw::contact) {
    moments.assign(4, unset);
    if (p.contacts)
      moments = {p.contacts->rolling(), p.contacts->sliding(), p.contacts->hysteresis(),
                 p.contacts->drag};
  }
  if (model.law == friction::FrictionLaw::table) moments = {p.load + p.viscous};
  moments.insert(moments.end(), p.effects.begin(), p.effects.end());
  return moments;
}

std::vector<friction::contact::BallFriction> ball_contacts(const Model& model,
                                                           const bearing::OperatingPoint& point,
                                                           const FrictionPrediction& prediction) {
  friction::BearingState<double> state = bearing_state(model, point, prediction.equilibrium.get());
  if (prediction.bearing) state.bearing = prediction.bearing.get();
  state.temperature = prediction.film.temperature;
  state.kinematic_viscosity = prediction.film.kinematic_viscosity;
  std::vector<friction::contact::BallFriction> balls;
  (void)contact_result(state, model.law_values, &balls);
  for (friction::contact::BallFriction& ball : balls)
    for (auto* contact : {&ball.inner, &ball.outer})
      if (*contact) (*contact)->rolling *= prediction.film.viscous_share;
  return balls;
}

double share_of_bearing(const effects::Description& effect, const Rig& rig) {
  return effect.drags_on_the_rotor && rig.coasts_down() ? 1.0 / rig.bearings : 1.0;
}

double rig_torque(const Rig& rig, double bearing_torque) { return rig.bearings * bearing_torque; }

FrictionPrediction predict_friction(const Model& model, const bearing::OperatingPoint& point,
                                    bool with_equilibrium, const effects::Record& record) {
  const Steps steps(model, with_equilibrium);
  RowPredictor row(model, steps, point, record);
  (void)row.predict(model, steps);
  return row.prediction(model);
}

void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium,
                   std::span<const effects::Record> records) {
  if (points.size() != predictions.size())
    throw std::invalid_argument(
        "predict_sweep: the number of predictions must equal the number of points");
  if (!records.empty() && records.size() != points.size())
    throw std::invalid_argument("predict_sweep: give one record for each point, or none");
  const Steps steps(model, with_equilibrium);
  const std::size_t chunks = (points.size() + points_of_a_thread - 1) / points_of_a_thread;
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t k) {
    const std::size_t first = k * points_of_a_thread,
                      count = std::min(points_of_a_thread, points.size() - first);
    std::vector<RowPredictor> rows;
    rows.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      rows.emplace_back(model, steps, points[first + i],
                        records.empty() ? effects::Record{} : records[first + i]);
    solve_balances(model, steps, rows);
    solve_contacts(model, steps, rows);
    for (std::size_t i = 0; i < count; ++i) {
      (void)rows[i].predict(model, steps);
      predictions[first + i] = rows[i].prediction(model);
    }
  });
}

std::vector<FrictionPrediction> predict_rows(const Model& model, const record::Record& record) {
  std::vector<bearing::OperatingPoint> points;
  std::vector<effects::Record> records;
  points.reserve(record.rows());
  records.reserve(record.rows());
  for (const Row& row : rows_of(record)) {
    points.push_back(row.point);
    records.push_back(row.record);
  }
  std::vector<FrictionPrediction> predictions(points.size());
  predict_sweep(model, points, predictions, false, records);
  return predictions;
}

}  // namespace raceway::model
