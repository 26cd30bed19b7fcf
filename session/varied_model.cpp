#include "session/detail/varied_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fit/problem.h"
#include "model/bearing_life.h"
#include "results/spindle_results.h"
#include "session/operating_point.h"
#include "session/solve_states.h"
#include "session/spindle_steady.h"
#include "session/table_columns.h"
#include "text/error.h"
#include "text/units.h"

namespace raceway::session::varied {
namespace {

constexpr std::size_t most_states = 10000;

bool in_celsius(std::string_view name) { return name.ends_with("_C"); }

bearing::OperatingPoint point_of_state(const State& state, const model::Model& model) {
  return point_of(model, {.speed_rpm = state[0],
                          .axial_load_N = state[1],
                          .radial_load_N = state[2],
                          .temperature_C = state[3]});
}

double life_of(const model::Model& model, const bearing::OperatingPoint& point) {
  const model::FrictionPrediction p = model::predict_friction(model, point, true);
  constexpr double hour = 3600.0;
  return p.report.converged() ? reference_life(model, point, p).reference / hour : unset;
}

double stiffness_of(const model::Model& model, const bearing::OperatingPoint& point) {
  const auto p = shaft::predict_shaft(model, shaft_points({&point, 1}));
  return p[0].equilibrium.report.converged() ? p[0].equilibrium.axial_stiffness / N_per_um : unset;
}

}  // namespace

std::vector<Axis> axes_of(const SensitivityQuestion& q, bool shaft) {
  return {{"speed_rpm", "--speed", q.speeds_rpm, text::speed_range},
          {"axial_load_N", "--axial-load", q.axial_loads_N,
           shaft ? text::signed_load_range : text::load_range},
          {"radial_load_N", "--radial-load", q.radial_loads_N, text::load_range},
          {"temperature_C", "--temperature", q.temperatures_C, text::temperature_range}};
}

std::vector<State> states_of(const std::vector<Axis>& axes) {
  std::vector<State> states{{unset, unset, unset, unset}};
  for (std::size_t a = axes.size(); a-- > 0;) {
    if (axes[a].values.empty()) continue;
    std::vector<State> more;
    for (const State& s : states)
      for (const double value : axes[a].values) {
        more.push_back(s);
        more.back()[a] = value;
      }
    states = std::move(more);
    if (states.size() > most_states)
      throw text::InputError(
          fmt::format("more than {} states are requested; give fewer speeds, loads or temperatures",
                      most_states));
  }
  return states;
}

std::vector<std::string> known_columns(const model::Model& model, bool steady) {
  std::vector<std::string> names;
  if (steady) {
    for (const results::RunColumn& c : results::run_columns(model, {}, {}))
      if (c.name != "speed_rpm") names.push_back(c.name);
    if (!model.spindle->network) {
      names.emplace_back(stiffness);
      names.emplace_back(hottest_ring);
    }
    return names;
  }
  names = state_columns(model);
  if (model.shaft)
    names.emplace_back(stiffness);
  else if (std::find(names.begin(), names.end(), life) == names.end())
    names.emplace_back(life);
  return names;
}

Predictor::Predictor(const SensitivityQuestion& question, std::vector<std::string> wanted,
                     const model::Model& model)
    : question_(question), wanted_(std::move(wanted)) {
  if (question.steady) return;
  const std::vector<std::string> table = state_columns(model);
  columns_ = table.size() - 1;  // the torque is none of them
  for (const std::string& name : wanted_) {
    const auto at = std::find(table.begin(), table.end(), name);
    places_.push_back(static_cast<std::size_t>(at - table.begin()));
    if (at != table.end())
      units_.push_back(text::column_unit(name));
    else
      units_.push_back(1.0);
  }
}

std::vector<double> Predictor::operator()(const files::ModelFile& file,
                                          const std::vector<State>& states) const {
  return question_.steady ? steady(file, states) : at_once(file.model, states);
}

std::vector<double> Predictor::at_once(const model::Model& model,
                                       const std::vector<State>& states) const {
  std::vector<bearing::OperatingPoint> points;
  for (const State& s : states) points.push_back(point_of_state(s, model));
  std::vector<double> columns(points.size() * columns_, unset);
  std::vector<friction::TablePoint> solved(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    solved[i].columns = std::span(columns).subspan(i * columns_, columns_);
  fill_table_line(model, points, solved, Columns::of_states);
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < wanted_.size(); ++k) {
      const double si = places_[k] == 0          ? solved[i].friction_moment
                        : places_[k] <= columns_ ? solved[i].columns[places_[k] - 1]
                        : wanted_[k] == life     ? life_of(model, points[i])
                                                 : stiffness_of(model, points[i]);
      values.push_back(si / units_[k]);
    }
  return values;
}

std::vector<double> Predictor::steady(const files::ModelFile& file,
                                      const std::vector<State>& states) const {
  spindle::Simulator simulator = simulator_of(file);
  simulator.stop_on(question_.cancelled);
  std::vector<double> values;
  for (const State& s : states) {
    spindle::Inputs inputs = question_.inputs.value_or(spindle::Inputs{
        .axial_load = file.model.shaft->external_load, .coolant_on = question_.coolant_on});
    inputs.speed = s[0] * rpm;
    spindle::Report report;
    const spindle::Moment m = simulator.steady(inputs, report);
    std::vector<results::RunColumn> known = results::run_columns(file.model, inputs, m);
    double hottest = unset;
    for (const spindle::BearingState& b : m.bearings)
      hottest = std::fmax(hottest, std::fmax(b.inner_ring_temperature, b.outer_ring_temperature));
    known.push_back({std::string(hottest_ring), celsius(hottest)});
    known.push_back({std::string(stiffness),
                     simulator.sets() ? simulator.sets()->axial_stiffness / N_per_um : unset});
    for (const std::string& name : wanted_) {
      const auto at = std::find_if(known.begin(), known.end(),
                                   [&](const results::RunColumn& c) { return c.name == name; });
      values.push_back(report.converged() && at != known.end() ? at->value : unset);
    }
  }
  return values;
}

Data::Data(const files::ModelFile& file, const SensitivityQuestion& question,
           std::vector<State> states)
    : question_(question), of_model_(file), states_(std::move(states)) {
  for (const files::ModelDatum& d : of_model_.data())
    all_.push_back({.name = d.name,
                    .value = d.value,
                    .origin = d.origin == files::ModelDatum::Origin::file         ? "file"
                              : d.origin == files::ModelDatum::Origin::by_default ? "default"
                                                                                  : "catalogue",
                    .whole = d.whole,
                    .has_elasticity = !in_celsius(d.name)});
  const std::vector<Axis> axes = axes_of(question, file.model.shaft.has_value());
  for (std::size_t a = 0; a < axes.size(); ++a)
    if (axes[a].values.size() == 1) {
      axes_.push_back(a);
      all_.push_back({.name = std::string(axes[a].name),
                      .value = axes[a].values.front(),
                      .origin = "asked",
                      .has_elasticity = !in_celsius(axes[a].name)});
    }
  for (const std::string& name : question.data) {
    const std::size_t before = asked_.size();
    for (std::size_t k = 0; k < all_.size(); ++k)
      if (all_[k].name.starts_with(name + ".")) asked_.push_back(k);
    if (asked_.size() == before) asked_.push_back(find(name));
  }
}

std::size_t Data::find(const std::string& name) const {
  for (std::size_t k = of_model_.data().size(); k < all_.size(); ++k)
    if (all_[k].name == name) return k;
  return of_model_.find(name);
}

bool Data::is_asked(std::size_t k) const {
  return asked_.empty() || std::find(asked_.begin(), asked_.end(), k) != asked_.end();
}

Outcome Data::predict(const Predictor& predictor,
                      std::span<const std::pair<std::size_t, double>> changes) const {
  if (question_.cancelled && *question_.cancelled) throw fit::Cancelled();
  std::vector<std::pair<std::size_t, double>> of_file;
  std::vector<State> states = states_;
  for (const auto& [k, value] : changes) {
    if (k < of_model_.data().size()) {
      of_file.emplace_back(k, value);
      continue;
    }
    const std::size_t axis = axes_[k - of_model_.data().size()];
    if (axis < 3 && value < 0.0 && all_[k].value >= 0.0)
      return {.refused = fmt::format("{} = {:.6g}: must not be negative", all_[k].name, value)};
    for (State& s : states) s[axis] = value;
  }
  try {
    files::ModelFile file = of_model_.with(of_file);
    if (question_.amend) question_.amend(file);
    return {.values = predictor(file, states)};
  } catch (const text::InputError& e) {
    return {.refused = e.without_place()};
  } catch (const std::invalid_argument& e) {
    return {.refused = e.what()};
  }
}

}  // namespace raceway::session::varied
