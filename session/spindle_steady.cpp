#include "session/spindle_steady.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/contact_pressure.h"
#include "files/plausible.h"
#include "life/roller_life.h"
#include "record/units.h"
#include "report/spindle_report.h"
#include "session/assumptions.h"
#include "session/beam_of_model.h"
#include "session/judged.h"
#include "session/open_input.h"
#include "session/roller_notes.h"
#include "spindle/loaded_shaft.h"
#include "text/error.h"

namespace raceway::session {
namespace {

model::Cells other_cells(model::Cells cells) {
  return cells == model::Cells::coarse ? model::Cells::medium
         : cells == model::Cells::fine ? model::Cells::medium
                                       : model::Cells::fine;
}

double hottest_inner_ring(const spindle::Moment& m) {
  double hottest = unset;
  for (const spindle::BearingState& b : m.bearings)
    hottest = std::fmax(hottest, b.inner_ring_temperature);
  return hottest;
}

/// Returns the flow of each circuit at the mean of its inlet and its outlet; empty if it stands.
std::vector<std::optional<spindle::ChannelFlow>> flows_at(const model::Model& model,
                                                          const results::SteadyState& s) {
  std::vector<std::optional<spindle::ChannelFlow>> list;
  if (!s.report.converged()) return list;
  for (const model::Coolant& c : model.spindle->channels()) {
    const spindle::CircuitState& now = s.moment.circuits[list.size()];
    list.emplace_back();
    if (s.inputs.coolant_on && c.flow > 0.0)
      list.back() = spindle::channel_flow(c, 0.5 * (now.inlet + now.outlet));
  }
  return list;
}

results::SteadyState steady_state(spindle::Simulator& simulator, const spindle::Inputs& inputs) {
  results::SteadyState s;
  s.inputs = inputs;
  s.moment = simulator.steady(inputs, s.report);
  if (s.report.converged() && simulator.sets()) {
    s.seats = simulator.seats();
    s.surfaces = simulator.surfaces();
    s.shaft = simulator.along_shaft(s.moment);
    s.stress = simulator.stresses(inputs.speed);
    s.axial_stiffness = simulator.sets()->axial_stiffness;
    s.bearings = simulator.sets()->bearings;
    const auto mounted = simulator.arrangement()->bearings();
    if (const spindle::LoadedShaft* const bent = simulator.shaft())
      for (std::size_t k = 0; k < s.bearings.size(); ++k) {
        const bearing::ContactPressure most =
            largest_pressure(*mounted[k].bearing, bent->bearings[k]);
        s.bearings[k].axial_load = bent->loads[k][0];
        s.bearings[k].inner_pressure = most.inner;
        s.bearings[k].outer_pressure = most.outer;
      }
  }
  return s;
}

/// Sections for the page, of up to a dozen of the speeds that have a steady state.
std::vector<report::DrawnField> fields_of(spindle::Simulator& simulator,
                                          const std::vector<results::SteadyState>& states) {
  constexpr std::size_t most = 12;
  std::vector<const results::SteadyState*> found;
  for (const results::SteadyState& s : states)
    if (s.report.converged()) found.push_back(&s);
  std::vector<report::DrawnField> fields;
  const std::size_t count = std::min(most, found.size());
  for (std::size_t k = 0; k < count; ++k) {
    const results::SteadyState& s = *found[count == 1 ? 0 : k * (found.size() - 1) / (count - 1)];
    spindle::Report report;
    static_cast<void>(simulator.steady(s.inputs, report));
    fields.push_back({.speed = s.inputs.speed, .cells = simulator.field(simulator.state())});
  }
  return fields;
}

/// Of the state that was found last.
void note_rollers(const model::Model& model, const spindle::Simulator& simulator,
                  SteadySpindle& answer) {
  const results::SteadyState& s = answer.states.back();
  const spindle::LoadedShaft* const bent = simulator.shaft();
  if (!s.report.converged() || !bent) return;
  for (std::size_t k = 0; k < bent->rollers.size(); ++k) {
    const model::RollerOnShaft& r = model.spindle->rollers[k];
    const bearing::RollerEquilibrium& e = bent->rollers[k];
    for (const std::string& note :
         notes_on_rollers(r.bearing, e, life::dynamic_load_rating(r.bearing.geometry()),
                          s.inputs.speed, std::hypot(e.load[0], e.load[1]))) {
      std::string text = fmt::format("{} at {:.6g} rpm: {}", r.name, s.inputs.speed / rpm, note);
      answer.roller_notes.push_back(std::move(text));
    }
  }
}

/// Refuses loads that the spindle has nothing to carry with.
void require_carried(const model::Model& model, const SteadyQuestion& q) {
  if (!std::isnan(q.belt_force) && !model.spindle->belt)
    throw text::InputError(
        "belt_force_N: the model has no belt: give [drive] position_mm and belt_force_N (0 is "
        "allowed)",
        {.key = "belt_force_N"});
  const bool loaded =
      q.radial_load != 0.0 || q.moment != 0.0 || (!std::isnan(q.axial_load) && q.axial_load != 0.0);
  if (loaded && model.spindle->network)
    throw text::InputError("a model with [network] has no shaft, so it cannot carry a load",
                           {.key = "network"});
}

}  // namespace

void require_spindle(const files::ModelFile& file) {
  if (file.model.spindle) return;
  throw text::InputError(file.source +
                             ": the model is not a spindle; a spindle needs [shaft] and [housing] "
                             "in addition to [arrangement]",
                         {.file = file.source, .key = "shaft"});
}

spindle::Simulator simulator_of(const files::ModelFile& file) {
  try {
    return spindle::Simulator(file.model);
  } catch (const std::invalid_argument& e) {
    throw text::InputError(fmt::format("{}: {}", file.source, e.what()), {.file = file.source});
  }
}

results::MeshEstimate mesh_estimate(const model::Model& model, const spindle::Inputs& inputs,
                                    const std::atomic<bool>* cancelled) {
  spindle::Simulator own(model);
  results::MeshEstimate mesh{.cells = own.cells()};
  if (model.spindle->network) return mesh;
  model::Model changed = model;
  changed.spindle->cells = other_cells(model.spindle->cells);
  spindle::Simulator other(changed);
  own.stop_on(cancelled);
  other.stop_on(cancelled);
  spindle::Report report, report_of_other;
  const spindle::Moment a = own.steady(inputs, report), b = other.steady(inputs, report_of_other);
  if (!report.converged() || !report_of_other.converged()) return mesh;
  mesh.other_cells = other.cells();
  mesh.speed = inputs.speed;
  mesh.displacement = a.displacement - b.displacement;
  mesh.inner_ring_rise = hottest_inner_ring(a) - hottest_inner_ring(b);
  mesh.front_force = a.front_force - b.front_force;
  return mesh;
}

std::string words(const results::MeshEstimate& mesh) {
  if (!mesh.known()) return fmt::format("{} cells", mesh.cells);
  return fmt::format(
      "{} cells; mesh check at the steady state: {} cells change the displacement by {:+.2g} um, "
      "the hottest inner ring by {:+.2g} K and the front force by {:+.2g} N ({:.6g} rpm)",
      mesh.cells, mesh.other_cells, -mesh.displacement / um, -mesh.inner_ring_rise,
      -mesh.front_force, mesh.speed / rpm);
}

SteadySpindle steady_spindle(const files::ModelFile& file, const SteadyQuestion& question) {
  require_spindle(file);
  for (const double speed : question.speeds) require_possible_speed(file.model, speed, "speed_rpm");
  require_possible_temperature(file.model, question.ambient_temperature, "ambient_temperature_C");
  require_carried(file.model, question);
  SteadySpindle answer{.file = file};
  if (!std::isnan(question.ambient_temperature))
    answer.doubt =
        files::looks_like_kelvin("ambient_temperature_C", celsius(question.ambient_temperature));
  spindle::Simulator simulator = simulator_of(file);
  simulator.stop_on(question.cancelled);
  for (const double speed : question.speeds) {
    const spindle::Inputs inputs{.speed = speed,
                                 .ambient_temperature = question.ambient_temperature,
                                 .motor_power = question.motor_power,
                                 .axial_load = std::isnan(question.axial_load)
                                                   ? file.model.shaft->external_load
                                                   : question.axial_load,
                                 .radial_load = question.radial_load,
                                 .moment = question.moment,
                                 .belt_force = question.belt_force,
                                 .coolant_on = question.coolant_on};
    try {
      answer.states.push_back(steady_state(simulator, inputs));
    } catch (const std::invalid_argument& e) {
      throw text::InputError(fmt::format("{}: {}", file.source, e.what()), {.file = file.source});
    }
    answer.states.back().channels = flows_at(file.model, answer.states.back());
    note_rollers(file.model, simulator, answer);
  }
  answer.findings = judge(file.model, answer.states);
  const auto last = std::find_if(answer.states.rbegin(), answer.states.rend(),
                                 [](const auto& s) { return s.report.converged(); });
  answer.mesh = last == answer.states.rend()
                    ? results::MeshEstimate{.cells = simulator.cells()}
                    : mesh_estimate(file.model, last->inputs, question.cancelled);
  if (question.assumptions && last != answer.states.rend())
    answer.assumptions = influential_assumptions(file, last->inputs, question.cancelled);
  if (last != answer.states.rbegin()) return answer;
  answer.end = simulator.state();
  answer.field = simulator.field(answer.end);
  return answer;
}

bool SteadySpindle::converged() const {
  return std::all_of(states.begin(), states.end(),
                     [](const auto& s) { return s.report.converged(); });
}

std::vector<std::string> SteadySpindle::notes() const {
  std::vector<std::string> lines = model::notes_of(findings);
  lines.insert(lines.end(), roller_notes.begin(), roller_notes.end());
  const bool coolant_on = states.empty() || states.front().inputs.coolant_on;
  if (std::string unused = unused_coolant_off(file.model, coolant_on, true); !unused.empty())
    lines.push_back(std::move(unused));
  return lines;
}

std::vector<record::Note> SteadySpindle::warnings() const {
  std::vector<record::Note> notes;
  if (!doubt.empty()) notes.push_back(record::note::unit(doubt, {.key = "ambient_temperature_C"}));
  for (const results::SteadyState& s : states)
    if (!s.report.converged())
      notes.push_back(record::note::not_converged(
          fmt::format("{:.6g} rpm: {}: {}", s.inputs.speed / rpm, spindle::name(s.report.status),
                      s.report.message)));
  append(notes, notes_of(record::note::over_limit, model::warnings_of(findings)));
  return notes;
}

std::string SteadySpindle::json(bool with_assumptions) const {
  return results::spindle_steady_json(file.model, states, mesh, findings,
                                      with_assumptions ? assumptions : results::Assumptions{});
}

std::string SteadySpindle::csv() const {
  return results::spindle_steady_text(file.model, states, file.text);
}

std::string SteadySpindle::page() const {
  spindle::Simulator simulator = simulator_of(file);
  return report::spindle_steady_report(of_page(file, file.model), states,
                                       fields_of(simulator, states), mesh, words(mesh), findings,
                                       assumptions);
}

std::string SteadySpindle::end_state() const {
  return results::spindle_state_json(file.model, end);
}

std::string SteadySpindle::field_csv() const {
  return results::spindle_field_text(field, file.model.spindle->name);
}

}  // namespace raceway::session
