#include "session/spindle_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "fit/problem.h"
#include "record/units.h"
#include "report/beam_report.h"
#include "results/shaft_results.h"
#include "session/judged.h"
#include "session/open_input.h"
#include "text/error.h"

namespace raceway::session {
namespace {

/// Nothing else has a direction: with the belt in the plane of y the two planes are those of the
/// springs.
model::Model in_plane_of_belt(model::Model model) {
  if (model.spindle->belt) model.spindle->belt->angle = 0.0;
  return model;
}

/// Frequencies of all bearings, NaN where the sets have no balance.
void add_rolling(const model::Model& model, const BeamOfModel& b, results::ModesAtSpeed& r) {
  const bearing::Arrangement& a = b.sets.arrangement();
  for (std::size_t i = 0; i < a.bearings().size(); ++i)
    r.rolling.emplace_back(results::bearing_place(a, i),
                           r.sets.converged() ? bearing::running_frequencies(
                                                    *a.bearings()[i].bearing, r.sets.bearings[i],
                                                    model.solver.race_control)
                                              : bearing::BearingFrequencies{});
  for (const model::RollerOnShaft& roller : model.spindle->rollers)
    r.rolling.emplace_back(roller.name, bearing::rolling_frequencies(roller.bearing.geometry()));
}

void require_unbalance(const ModesQuestion& q, const spindle::Beam& beam) {
  const bool damped = q.damping_ratio > 0.0 && q.damping_ratio <= 1.0;
  if (!std::isnan(q.damping_ratio) && !damped)
    throw text::InputError(
        fmt::format("damping = {:.6g}: must be above 0 and at most 1", q.damping_ratio),
        {.key = "damping"});
  if (!q.unbalance) return;
  if (!damped)
    throw text::InputError(
        "unbalance: give a damping ratio as well; without damping, the amplitude is infinite at a "
        "resonance",
        {.key = "damping"});
  if (!(q.unbalance->size > 0.0) || !(q.unbalance->position >= 0.0) ||
      q.unbalance->position > beam.length())
    throw text::InputError(
        fmt::format("unbalance of {:.6g} g mm at {:.6g} mm: the unbalance must be above 0, and its "
                    "position must be on the shaft, from 0 to {:.6g} mm",
                    q.unbalance->size / (1e-3 * mm), q.unbalance->position / mm,
                    beam.length() / mm),
        {.key = "unbalance"});
}

std::vector<results::ModesAtSpeed> find_all(const model::Model& model, BeamOfModel& b,
                                            const ModesQuestion& q) {
  std::vector<results::ModesAtSpeed> results(q.speeds.size());
  std::vector<double> held_at;
  std::vector<std::vector<spindle::Spring>> springs;
  for (std::size_t i = 0; i < q.speeds.size(); ++i) {
    results::ModesAtSpeed& r = results[i];
    r.speed = q.speeds[i];
    const spindle::Inputs inputs = inputs_at(model, r.speed, q.coolant_on);
    r.sets = b.sets.at(inputs, q.warm);
    r.damping_ratio = q.damping_ratio;
    add_rolling(model, b, r);
    if (q.unbalance) r.nose.emplace();
    if (!r.sets.converged()) continue;
    r.roller_names = b.roller_names;
    if (bends(*model.spindle)) {
      r.shaft = bend(in_plane_of_belt(model), b, r.sets, inputs);
      if (!r.shaft->report.converged()) {
        r.sets.status = spindle::Status::no_equilibrium;
        r.sets.message = "the shaft has no equilibrium under the belt force";
        continue;
      }
      r.sets.bearings = r.shaft->bearings;
    }
    r.springs = springs_of(b, r.sets, r.shaft);
    if (q.unbalance) r.nose = spindle::unbalance_orbit(b.beam, r.springs, r.speed, *q.unbalance);
    held_at.push_back(r.speed);
    springs.push_back(r.springs);
  }
  auto next = results.begin();
  constexpr std::size_t most_at_once = 200;  // between two looks at whether to go on
  for (std::size_t begin = 0; begin < held_at.size(); begin += most_at_once) {
    if (q.cancelled && q.cancelled->load()) throw fit::Cancelled();
    const std::size_t count = std::min(most_at_once, held_at.size() - begin);
    for (spindle::Modes& modes :
         spindle::campbell(b.beam, std::span(held_at).subspan(begin, count),
                           std::span(springs).subspan(begin, count), q.count)) {
      next = std::find_if(next, results.end(), [](const auto& r) { return r.sets.converged(); });
      (next++)->modes = std::move(modes);
    }
  }
  return results;
}

}  // namespace

SpindleModes spindle_modes(const files::ModelFile& file, const ModesQuestion& question) {
  constexpr std::size_t most = 10000;
  if (question.speeds.size() > most)
    throw text::InputError(fmt::format("raceway modes: {} speeds are given; at most {} are allowed",
                                       question.speeds.size(), most),
                           {.key = "--speed"});
  for (const double speed : question.speeds) require_possible_speed(file.model, speed, "speed_rpm");
  SpindleModes answer{.file = file,
                      .beam = beam_of(file, 0.0),
                      .warm = question.warm,
                      .coolant_on = question.coolant_on,
                      .damping_ratio = question.damping_ratio};
  require_unbalance(question, answer.beam.beam);
  answer.beam.sets.stop_on(question.cancelled);
  answer.speeds = find_all(file.model, answer.beam, question);
  answer.beam.sets.stop_on(nullptr);
  answer.findings = judge_speeds(file.model, question.speeds);
  return answer;
}

bool SpindleModes::converged() const {
  return std::all_of(speeds.begin(), speeds.end(), [](const auto& r) { return r.converged(); });
}

std::vector<std::string> SpindleModes::notes() const {
  std::vector<std::string> lines{
      std::isnan(damping_ratio) ? "the model does not include damping, so damping_ratio is empty; "
                                  "the model does not include the deflection of the housing"
                                : "damping_ratio is the given value; the model does not "
                                  "include the deflection of the housing"};
  if (std::string unused = unused_coolant_off(file.model, coolant_on, warm); !unused.empty())
    lines.push_back(std::move(unused));
  return lines;
}

std::vector<record::Note> SpindleModes::warnings() const {
  std::vector<record::Note> notes;
  for (const results::ModesAtSpeed& r : speeds)
    if (!r.converged())
      notes.push_back(record::note::not_converged(
          fmt::format("{:.6g} rpm: {}{}", r.speed / rpm, r.status(),
                      r.sets.message.empty() ? "" : ", " + r.sets.message)));
  append(notes, notes_of(record::note::over_limit, model::warnings_of(findings)));
  return notes;
}

std::string SpindleModes::json() const {
  return results::campbell_json(beam.sets.arrangement(), speeds, file.source, findings);
}

std::string SpindleModes::csv() const {
  return results::campbell_text(beam.sets.arrangement(), speeds, file.source, file.text);
}

std::string SpindleModes::shapes_csv() const {
  return results::mode_shapes_text(beam.beam, speeds, file.source, file.text);
}

std::string SpindleModes::page() const {
  return report::modes_report(of_page(file, file.model), beam.sets.arrangement(), beam.beam,
                              beam.places, warm, speeds, findings);
}

}  // namespace raceway::session
