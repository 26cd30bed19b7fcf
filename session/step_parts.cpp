#include "session/step_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "shaft/fit_kinematic_law.h"
#include "shaft/shaft_prediction.h"
#include "text/number_text.h"

namespace raceway::session {
namespace {

constexpr int points_of_kinematic_law = 40;
constexpr double grid_step = 500 * rpm, grid_end = 60000 * rpm;

std::vector<shaft::ShaftPrediction> predicted_shaft(const model::Model& model,
                                                    const std::vector<double>& speeds,
                                                    double temperature) {
  std::vector<shaft::ShaftPoint> points;
  for (const double speed : speeds)
    points.push_back(
        {.speed = speed,
         .external_load = model.shaft->external_load,
         .temperature = std::isnan(temperature) ? model.rig.temperature : kelvin(temperature)});
  return shaft::predict_shaft(model, points);
}

/// Up to the least speed of a grid that has this power [W].
std::vector<results::PowerAtSpeed> powers_of_model(const model::Model& model, double highest,
                                                   double temperature) {
  std::vector<double> speeds;
  for (double speed = grid_step; speed <= grid_end; speed += grid_step) speeds.push_back(speed);
  const std::vector<shaft::ShaftPrediction> found = predicted_shaft(model, speeds, temperature);
  std::vector<results::PowerAtSpeed> powers;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (found[k].status() != bearing::SolveStatus::converged) break;
    powers.push_back({speeds[k], found[k].power_loss});
    if (found[k].power_loss >= highest) break;
  }
  return powers;
}

std::vector<shaft::DisplacementPoint> curve_of_model(const model::Model& model, double highest) {
  std::vector<double> speeds;
  for (int k = 0; k <= points_of_kinematic_law; ++k)
    speeds.push_back(highest * k / points_of_kinematic_law);
  const std::vector<shaft::ShaftPrediction> found = predicted_shaft(model, speeds, unset);
  std::vector<shaft::DisplacementPoint> curve;
  for (std::size_t k = 0; k < speeds.size(); ++k)
    if (found[k].equilibrium.report.converged())
      curve.push_back({.speed = speeds[k], .displacement = found[k].displacement});
  return curve;
}

void add_kinematic_law(const std::vector<shaft::DisplacementPoint>& curve, StepParts& parts) {
  try {
    const shaft::KinematicLawFit fit = shaft::fit_kinematic_law(curve);
    if (!fit.converged()) {
      parts.notes.push_back(
          "the fit of the kinematic law did not converge, so the correction has no kinematic "
          "displacement");
      return;
    }
    parts.kinematic = fit.law;
    if (fit.verdict != shaft::KinematicLawVerdict::follows)
      parts.notes.push_back(
          fmt::format("the kinematic law does not follow the displacement curve: its largest error "
                      "is {:.3g} um",
                      fit.max_abs / um));
  } catch (const std::invalid_argument& e) {
    parts.notes.push_back(fmt::format(
        "no kinematic law was fitted: {}; the correction has no kinematic displacement", e.what()));
  }
}

}  // namespace

std::string name_of(const spindle::StepResponse& step) {
  if (!step.load_case.empty()) return step.load_case;
  const std::string speed = fmt::format("{:.6g} rpm", step.speed / rpm);
  if (step.stepped == spindle::Stepped::speed) return speed;
  return fmt::format("{} N {} at {}", step.load,
                     step.stepped == spindle::Stepped::axial_load ? "axial" : "radial", speed);
}

double friction_power(const model::Model& model, double speed, double temperature) {
  const shaft::ShaftPrediction found = predicted_shaft(model, {speed}, temperature).front();
  if (found.status() != bearing::SolveStatus::converged)
    throw std::invalid_argument(fmt::format(
        "speed = {:.6g} rpm: the bearing sets of the model have no equilibrium at this speed",
        speed / rpm));
  return found.power_loss;
}

double kinematic_at(const model::Model& model, double speed) {
  return predicted_shaft(model, {speed}, unset).front().displacement;
}

StepParts step_parts(const spindle::StepResponses& responses, const model::Model* model,
                     double temperature) {
  StepParts parts;
  double highest = 0.0;
  std::vector<shaft::DisplacementPoint> at_once{{.speed = 0.0, .displacement = 0.0}};
  for (const spindle::StepResponse& step : responses.steps) {
    if (!step.converged()) continue;
    highest = std::max(highest, step.power_end);
    if (!(step.speed > 0.0)) continue;
    parts.power.push_back({step.speed, step.power_end});
    at_once.push_back({.speed = step.speed, .displacement = step.kinematic});
  }
  if (parts.power.empty() && model) {
    parts.power = powers_of_model(*model, highest, temperature);
    parts.notes.push_back(
        fmt::format("the power at each speed comes from the friction of the model at {:.4g} C",
                    std::isnan(temperature) ? celsius(model->rig.temperature) : temperature));
  }
  std::sort(parts.power.begin(), parts.power.end(),
            [](const auto& a, const auto& b) { return a.speed < b.speed; });
  const auto same = [](const auto& a, const auto& b) { return a.speed == b.speed; };
  parts.power.erase(std::unique(parts.power.begin(), parts.power.end(), same), parts.power.end());
  const bool moves = std::any_of(at_once.begin(), at_once.end(),
                                 [](const auto& p) { return p.displacement != 0.0; });
  if (model && !parts.power.empty())
    add_kinematic_law(curve_of_model(*model, parts.power.back().speed), parts);
  else if (moves)
    add_kinematic_law(at_once, parts);
  else
    parts.notes.push_back(
        "the correction has no kinematic displacement: no MODEL describes the bearing sets, and no "
        "load case has a displacement at 0 s");
  return parts;
}

}  // namespace raceway::session
