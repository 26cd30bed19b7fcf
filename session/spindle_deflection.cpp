#include "session/spindle_deflection.h"

#include <fmt/format.h>

#include "record/units.h"
#include "report/beam_report.h"
#include "session/judged.h"
#include "session/open_input.h"
#include "text/error.h"

namespace raceway::session {
namespace {

/// The bent shaft by the stiffness that the sets have without the force, each `stiffer` times as
/// stiff; empty where nothing holds it.
Eigen::VectorXd tangent_line(const BeamOfModel& b, const results::DeflectionResult& r,
                             double stiffer = 1.0) {
  if (r.axial || !r.sets.converged()) return {};
  std::vector<double> places;
  std::vector<spindle::PlaneSpring> in_y;
  for (const spindle::Spring& s : springs_of(b, r.sets, r.unloaded)) {
    places.push_back(s.position);
    in_y.push_back(s.y);
    in_y.back().radial *= stiffer;
    in_y.back().coupling *= stiffer;
    in_y.back().tilt *= stiffer;
  }
  const spindle::BeamLoad load[] = {{.position = r.at, .force = r.force, .moment = -r.moment}};
  const spindle::Deflection d = spindle::deflect(b.beam, places, in_y, load);
  return d.found ? d.shape : Eigen::VectorXd();
}

/// Displacement where the force acts, by that stiffness.
double tangent_displacement(const BeamOfModel& b, const results::DeflectionResult& r) {
  if (r.axial) return r.force / r.sets.equilibrium.axial_stiffness;
  const Eigen::VectorXd shape = tangent_line(b, r);
  return shape.size() > 0 ? b.beam.at(r.at, shape)[0] : unset;
}

results::DeflectionResult solve_deflection(const model::Model& model, BeamOfModel& b,
                                           const DeflectionQuestion& q) {
  results::DeflectionResult r{.speed = q.speed,
                              .force = q.force,
                              .at = q.at,
                              .axial = q.axial,
                              .axial_force = q.axial_force,
                              .moment = q.moment,
                              .sets = {},
                              .shaft = {},
                              .roller_names = b.roller_names};
  const spindle::Inputs inputs = inputs_at(model, r.speed, q.coolant_on);
  r.sets = b.sets.at(inputs, q.warm);
  if (!r.sets.converged()) return r;
  if (bends(*model.spindle)) {
    r.unloaded = bend(model, b, r.sets, inputs);
    if (!r.unloaded->report.converged()) {
      r.shaft.report = r.unloaded->report;
      return r;
    }
    r.sets.bearings = r.unloaded->bearings;
  }
  r.tangent = tangent_displacement(b, r);
  spindle::ShaftLoad load{.position = r.at};
  if (r.axial) {
    load.axial = r.force;
  } else {
    // θ = dv/ds counts rearwards: a force in front of its place turns the shaft against it.
    load.radial = r.force, load.axial = r.axial_force, load.moment = -r.moment;
  }
  r.shaft = bend(model, b, r.sets, inputs, &load);
  if (!r.shaft.report.converged()) return r;
  const double axial =
      r.shaft.position - (r.unloaded ? r.unloaded->position : r.sets.equilibrium.position);
  Eigen::VectorXd line = r.shaft.y;
  if (r.unloaded) line -= r.unloaded->y;
  r.displacement = r.axial ? axial : b.beam.at(r.at, line)[0];
  r.nose = r.axial ? axial : line[0];
  r.slope = line[1];
  return r;
}

}  // namespace

void check(const DeflectionQuestion& q) {
  const auto refuse = [&](const std::string& why, const std::string& key) {
    throw text::InputError((q.wording == Wording::flags ? "raceway deflection: " : "") + why,
                           {.key = key});
  };
  const std::string force = named(q.wording, "--force", "force_N");
  const std::string moment = named(q.wording, "--moment", "moment_Nm");
  if (q.force == 0.0 && q.moment == 0.0)
    refuse(fmt::format("{} = 0 N: give a force, or a moment with {}", force, moment), force);
  if (!q.axial || (q.axial_force == 0.0 && q.moment == 0.0)) return;
  refuse(fmt::format("{} needs a radial {} (0 is allowed)",
                     q.moment != 0.0 ? moment : named(q.wording, "--axial-force", "axial_force_N"),
                     force),
         named(q.wording, "--direction", "direction"));
}

SpindleDeflection spindle_deflection(const files::ModelFile& file,
                                     const DeflectionQuestion& question) {
  check(question);
  require_possible_speed(file.model, question.speed,
                         named(question.wording, "--speed", "speed_rpm"));
  SpindleDeflection answer{.file = file,
                           .beam = beam_of(file, question.at),
                           .warm = question.warm,
                           .coolant_on = question.coolant_on};
  answer.beam.sets.stop_on(question.cancelled);
  answer.result = solve_deflection(file.model, answer.beam, question);
  answer.beam.sets.stop_on(nullptr);
  answer.findings =
      judge(file.model, answer.beam.sets.arrangement(), answer.result, question.wording);
  return answer;
}

std::vector<std::string> SpindleDeflection::notes() const {
  std::vector<std::string> lines = model::notes_of(findings);
  if (std::string unused = unused_coolant_off(file.model, coolant_on, warm); !unused.empty())
    lines.push_back(std::move(unused));
  if (result.axial && result.at != 0.0)
    lines.emplace_back(
        "the position of an axial force has no effect, because the force acts along the axis of "
        "the shaft");
  lines.emplace_back(
      "the housing is assumed to be rigid: these displacements do not include its deflection");
  return lines;
}

std::vector<record::Note> SpindleDeflection::warnings() const {
  if (converged()) return notes_of(record::note::over_limit, model::warnings_of(findings));
  return {record::note::not_converged(
      fmt::format("{:.6g} rpm: {}{}", result.speed / rpm, result.status(),
                  result.sets.message.empty() ? "" : ", " + result.sets.message))};
}

std::string SpindleDeflection::json() const {
  return results::deflection_json(beam.sets.arrangement(), result, file.source, findings);
}

std::string SpindleDeflection::csv() const {
  return results::deflection_text(beam.beam, result, file.source, file.text);
}

std::string SpindleDeflection::page() const {
  constexpr double rigid = 1e6;  // times as stiff
  return report::deflection_report(of_page(file, file.model), beam.sets.arrangement(), beam.beam,
                                   beam.places, warm, result, tangent_line(beam, result),
                                   tangent_line(beam, result, rigid), findings);
}

}  // namespace raceway::session
