#include "session/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/plausible.h"
#include "session/detail/global_sensitivity.h"
#include "session/detail/local_sensitivity.h"
#include "session/detail/varied_model.h"
#include "session/solve_states.h"
#include "session/spindle_steady.h"
#include "session/table_columns.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::session {

using results::PredictionSensitivity;
using results::Sensitivity;

namespace {

void require_question(const files::ModelFile& file, const SensitivityQuestion& q) {
  const auto named_as = [&](const varied::Axis& axis) {
    return std::string(q.wording == Wording::flags ? axis.flag : axis.name);
  };
  if (q.steady) require_spindle(file);
  const bool shaft = file.model.shaft.has_value();
  for (const varied::Axis& axis : varied::axes_of(q, shaft)) {
    if (axis.name == "speed_rpm" && axis.values.empty())
      throw text::InputError(named_as(axis) + " is missing", {.key = named_as(axis)});
    for (const double value : axis.values) text::require_range(value, axis.range, named_as(axis));
    if (axis.values.empty()) continue;
    if (q.steady && axis.name != "speed_rpm")
      throw text::InputError(fmt::format("{}: not possible with the steady state of a spindle, "
                                         "which uses the loads and temperatures of the model",
                                         named_as(axis)),
                             {.file = file.source, .key = named_as(axis)});
    if (shaft && axis.name == "radial_load_N")
      throw text::InputError(
          fmt::format("{}: {} has an [arrangement]; for a shaft, only axial loads are possible",
                      named_as(axis), file.source),
          {.file = file.source, .key = named_as(axis)});
  }
  if (!shaft && q.axial_loads_N.empty() && std::isnan(file.model.rig.axial_load)) {
    const std::string name = named(q.wording, "--axial-load", "axial_load_N");
    throw text::InputError(
        fmt::format("{} is missing, and {} has no axial_load_N under [rig]", name, file.source),
        {.file = file.source, .key = name});
  }
}

std::vector<std::string> wanted_columns(const model::Model& model, const SensitivityQuestion& q) {
  const auto words = sensitivity_words(model, q.steady);
  const std::vector<std::string> columns = varied::known_columns(model, q.steady);
  std::vector<std::string> asked = q.predictions, wanted;
  if (asked.empty()) asked.emplace_back(model.shaft ? "displacement" : "torque");
  for (const std::string& one : asked) {
    const auto word =
        std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == one; });
    const std::string& name = word == words.end() ? one : word->second;
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) {
      std::vector<std::string> all;
      for (const auto& [short_name, column] : words) all.push_back(short_name);
      all.insert(all.end(), columns.begin(), columns.end());
      throw text::InputError(
          fmt::format("{}: unknown prediction; must be one of {}", one, text::listed(all)),
          {.key = one});
    }
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
  }
  return wanted;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> sensitivity_words(const model::Model& model,
                                                                   bool steady) {
  if (steady && model.spindle && model.spindle->network) return {{"heat", "friction_power_W"}};
  if (steady)
    return {{"displacement", "axial_displacement_um"},
            {"heat", "friction_power_W"},
            {"preload", "front_force_N"},
            {"stiffness", std::string(varied::stiffness)},
            {"temperature", std::string(varied::hottest_ring)}};
  std::vector<std::pair<std::string, std::string>> words{
      {"torque", "friction_torque_Nmm"},
      {"heat", "power_loss_W"},
      {"displacement", "axial_displacement_um"},
      {"stiffness", std::string(varied::stiffness)}};
  if (model.shaft) {
    words.emplace_back("preload", "front_force_N");
    // That of the bearing at the tool.
    for (const std::string& name : state_columns(model))
      if (name.ends_with("_inner_contact_angle_deg")) {
        words.emplace_back("contact-angle", name);
        break;
      }
  } else {
    words.emplace_back("contact-angle", "inner_contact_angle_max_deg");
    words.emplace_back("pressure", "inner_contact_pressure_MPa");
    words.emplace_back("life", std::string(varied::life));
  }
  return words;
}

Sensitivity sensitivity(Messages& messages, const files::ModelFile& file,
                        const SensitivityQuestion& q) {
  require_question(file, q);
  const model::Model& model = file.model;
  const varied::Predictor predictor(q, wanted_columns(model, q), model);
  for (const double value : q.temperatures_C)
    if (const std::string doubt = files::looks_like_kelvin("temperature_C", value); !doubt.empty())
      messages.say(record::note::odd_value(doubt, {.key = "temperature_C"}));
  const std::vector<varied::Axis> axes = varied::axes_of(q, model.shaft.has_value());
  const std::vector<varied::State> states = varied::states_of(axes);
  varied::Data data(file, q, states);
  Sensitivity s{.source = file.source, .model = model.name, .samples = q.samples, .seed = q.seed};
  s.states.resize(states.size());
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (axes[a].values.empty()) continue;
    s.inputs.emplace_back(axes[a].name);
    for (std::size_t k = 0; k < states.size(); ++k) s.states[k].push_back(states[k][a]);
  }

  varied::take_spreads(model, q, data);
  const varied::Outcome here = data.predict(predictor, {});
  if (!here.refused.empty()) throw text::InputError(file.source + ": " + here.refused);
  const std::vector<varied::Around> around = predict_around(data, predictor, q, s);
  const std::vector<std::size_t> places =
      take_what_enters(data, around, here.values, q.samples > 0, s);
  const std::size_t columns = predictor.wanted().size();
  for (std::size_t i = 0; i < here.values.size(); ++i) {
    PredictionSensitivity p{
        .name = predictor.wanted()[i % columns], .state = i / columns, .value = here.values[i]};
    differentiate(i, s.data, places, around, p);
    s.predictions.push_back(std::move(p));
  }
  if (q.samples > 0)
    sample(data, predictor, q, places, s);
  else
    s.sampled.clear();
  return s;
}

std::string words_of_state(const Sensitivity& s, std::size_t state) {
  std::string words;
  for (std::size_t k = 0; k < s.inputs.size(); ++k)
    words += fmt::format("{}{} {:.6g}", k == 0 ? "" : ", ", s.inputs[k], s.states[state][k]);
  return words;
}

std::vector<std::string> sensitivity_warnings(const Sensitivity& s) {
  std::vector<std::string> lines;
  for (const PredictionSensitivity& p : s.predictions)
    if (!std::isfinite(p.value))
      lines.push_back(fmt::format("{} has no value at {}", p.name, words_of_state(s, p.state)));
  if (s.failed > 0)
    lines.push_back(fmt::format(
        "{} of {} evaluations have no prediction, and their samples are not used: {}; first at {}",
        s.failed, s.evaluations, s.why_failed, [&] {
          std::vector<std::string> at;
          for (std::size_t k = 0; k < s.first_failed.size(); ++k)
            at.push_back(fmt::format("{} = {:.6g}", s.data[s.sampled[k]].name, s.first_failed[k]));
          return text::listed(at);
        }()));
  return lines;
}

}  // namespace raceway::session
