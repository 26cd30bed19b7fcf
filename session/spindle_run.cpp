#include "session/spindle_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "files/plausible.h"
#include "files/spindle_record.h"
#include "record/units.h"
#include "report/spindle_report.h"
#include "session/assumptions.h"
#include "session/beam_of_model.h"
#include "session/judged.h"
#include "session/open_input.h"
#include "session/spindle_steady.h"
#include "spindle/drawn_run.h"
#include "spindle/record_rows.h"
#include "text/error.h"

namespace raceway::session {
namespace {

record::Record read_programme(const RunQuestion& q, const files::ModelFile& file) {
  return files::read_spindle_record(q.programme, *file.model.spindle, q.reading.options(file));
}

/// Of a temperature that the spindle is to run under, the first row tells.
void warn_of_kelvin(Messages& messages, const record::Record& record) {
  for (const record::Column& column : record.columns) {
    const std::string_view name = column.channel->name;
    if (!name.ends_with("_C") || !column.channel->is_input() || column.values.empty()) continue;
    const std::string doubt = files::looks_like_kelvin(name, celsius(column.values.front()));
    if (!doubt.empty())
      messages.say(record::note::unit(record.source + ": " + doubt,
                                      {.file = record.source, .key = std::string(name)}));
  }
}

std::vector<spindle::ProfileRow> read_profile(Messages& messages, const RunQuestion& q,
                                              const files::ModelFile& file) {
  const record::Record record = read_programme(q, file);
  messages.say(record.notes);
  warn_of_kelvin(messages, record);
  require_possible(file.model, record);
  require_possible_temperature(file.model, q.ambient_temperature, "ambient_temperature_C");
  if (!std::isnan(q.ambient_temperature))
    if (const std::string doubt =
            files::looks_like_kelvin("ambient_temperature_C", celsius(q.ambient_temperature));
        !doubt.empty())
      messages.say(record::note::unit(doubt, {.key = "ambient_temperature_C"}));
  const std::string& name = q.programme.name;
  if (record.runs.size() > 1)
    throw text::InputError(
        fmt::format("{}: the file has {} runs, but a speed programme can have only one", name,
                    record.runs.size()),
        {.file = name, .key = "run_id"});
  try {
    std::vector<spindle::ProfileRow> profile = spindle::profile_of(record);
    for (spindle::ProfileRow& row : profile) {
      if (!q.coolant_on) row.inputs.coolant_on = false;
      if (!std::isnan(q.ambient_temperature))
        row.inputs.ambient_temperature = q.ambient_temperature;
      if (!record.has(record::axial_load)) row.inputs.axial_load = file.model.shaft->external_load;
    }
    return profile;
  } catch (const std::invalid_argument& e) {
    throw text::InputError(e.what(), {.file = name});
  }
}

/// What to begin with; a programme that begins before it counts its time anew.
std::optional<spindle::State> read_start(Messages& messages, const RunQuestion& q,
                                         double first_row) {
  if (!q.start) {
    if (first_row < 0.0)
      throw text::InputError(
          fmt::format("{}: time_s = {:.6g} s: a programme must begin at 0 s or later",
                      q.programme.name, first_row),
          {.file = q.programme.name, .key = "time_s"});
    return std::nullopt;
  }
  spindle::State start = q.start->text ? results::parse_spindle_state(*q.start->text, q.start->name)
                                       : results::read_spindle_state(q.start->name);
  if (first_row < start.time) {
    messages.say(record::note::read_as(
        fmt::format("{} was saved at {:.6g} s, but the programme begins at {:.6g} s: the time of "
                    "the programme is measured from the saved state",
                    q.start->name, start.time, first_row),
        {.file = q.start->name}));
    start.time = std::min(0.0, first_row);
  }
  return start;
}

}  // namespace

SpindleRun simulate_spindle(Messages& messages, const files::ModelFile& file,
                            const RunQuestion& question) {
  require_spindle(file);
  const std::string& name = question.programme.name;
  if (const std::string unused = unused_coolant_off(file.model, question.coolant_on, true);
      !unused.empty())
    messages.say(record::note::unused(unused, {.key = "coolant_on"}));
  SpindleRun answer{.file = file, .programme = name};
  answer.profile = read_profile(messages, question, file);
  answer.start = read_start(messages, question, answer.profile.front().time);
  spindle::Simulator simulator = simulator_of(file);
  simulator.stop_on(question.cancelled);
  try {
    answer.run = simulator.simulate(answer.profile, answer.start ? &*answer.start : nullptr);
  } catch (const std::invalid_argument& e) {
    throw text::InputError(fmt::format("{} with {}: {}", name, file.source, e.what()),
                           {.file = question.start ? question.start->name : name});
  }
  answer.field = simulator.field(answer.run.end);
  spindle::add_end(simulator, answer.profile, answer.start ? &*answer.start : nullptr, answer.run);
  answer.findings = judge(file.model, answer.profile, answer.run);
  const auto fastest = std::max_element(
      answer.profile.begin(), answer.profile.end(),
      [](const auto& a, const auto& b) { return a.inputs.speed < b.inputs.speed; });
  answer.mesh = question.mesh ? mesh_estimate(file.model, fastest->inputs, question.cancelled)
                              : results::MeshEstimate{.cells = simulator.cells()};
  if (question.assumptions)
    answer.assumptions = influential_assumptions(file, fastest->inputs, question.cancelled);
  return answer;
}

std::vector<record::Note> SpindleRun::warnings() const {
  std::vector<record::Note> notes;
  if (!converged())
    notes.push_back(record::note::not_converged(fmt::format(
        "{}: {} at {:.6g} s; the result has {} of {} rows", spindle::name(run.report.status),
        run.report.message, run.end.time, rows_reached(), rows_asked())));
  append(notes, notes_of(record::note::over_limit, model::warnings_of(findings)));
  return notes;
}

std::string SpindleRun::json(bool with_assumptions) const {
  return results::spindle_run_json(file.model, profile, run, mesh, findings,
                                   with_assumptions ? assumptions : results::Assumptions{});
}

std::string SpindleRun::csv() const {
  return results::spindle_run_text(file.model, profile, run, file.text);
}

std::string SpindleRun::page() const {
  spindle::Simulator simulator = simulator_of(file);
  const spindle::DrawnRun drawn =
      spindle::drawn_run(simulator, profile, start ? &*start : nullptr, run);
  std::vector<report::DrawnField> fields;
  for (const spindle::State& state : drawn.states) {
    const auto row = std::lower_bound(drawn.rows.begin(), drawn.rows.end(), state.time,
                                      [](const auto& r, double time) { return r.time < time; });
    fields.push_back({.time = state.time,
                      .speed = row == drawn.rows.end() ? unset : row->inputs.speed,
                      .cells = simulator.field(state)});
  }
  return report::spindle_run_report(of_page(file, file.model), programme, rows_asked(), run, drawn,
                                    fields, mesh, words(mesh), findings, assumptions);
}

std::string SpindleRun::end_state() const {
  return results::spindle_state_json(file.model, run.end);
}

std::string SpindleRun::field_csv() const {
  return results::spindle_field_text(field, file.model.spindle->name);
}

}  // namespace raceway::session
