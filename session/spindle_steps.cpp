#include "session/spindle_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/spindle_record.h"
#include "record/units.h"
#include "report/step_report.h"
#include "results/step_results.h"
#include "session/beam_of_model.h"
#include "session/judged.h"
#include "session/open_input.h"
#include "session/step_parts.h"
#include "text/error.h"
#include "text/number_text.h"

namespace raceway::session {
namespace {

using text::number;

constexpr double one_hour = 3600.0;

spindle::Inputs conditions_of(const SpindleSteps& steps) {
  spindle::Inputs inputs;
  inputs.coolant_on = steps.coolant_on;
  return inputs;
}

void note_unsettled(const spindle::StepResponse& step, std::vector<record::Note>& notes) {
  if (!step.converged() || step.fit.settled) return;
  notes.push_back(record::note::unknown(
      fmt::format("{}: the time constant of {:.3g} min is more than half of the recorded time, so "
                  "gain and time constant are uncertain; record a longer step",
                  name_of(step), step.fit.one.time_constant / spindle::one_minute)));
}

std::vector<record::Note> notes_on_steps(const spindle::StepResponses& responses,
                                         const spindle::PowerLaws& laws) {
  std::vector<record::Note> notes;
  std::size_t two = 0;
  for (const spindle::StepResponse& step : responses.steps) {
    two += step.fit.two_needed ? 1 : 0;
    note_unsettled(step, notes);
  }
  for (const spindle::LoadSteps& at : responses.loads)
    for (const spindle::StepResponse& step : at.steps) note_unsettled(step, notes);
  if (two > 0)
    notes.push_back(record::note::assumed(fmt::format(
        "{} of {} step responses need two time constants", two, responses.steps.size())));
  if (!std::isnan(laws.gain_line.offset))
    notes.push_back(record::note::assumed(fmt::format(
        "the lines of gain K(P) and time constant T(P) over the power P approximate the step "
        "responses: K(0) = {} um has no physical meaning; valid powers: {} to {} W",
        number(laws.gain_line.offset / um, 3), number(laws.valid_from),
        std::isinf(laws.valid_to) ? std::string("inf") : number(laws.valid_to))));
  return notes;
}

void add_laws(SpindleSteps& steps) {
  steps.laws = spindle::fit_power_laws(spindle::at_powers(steps.responses.steps));
  steps.notes = notes_on_steps(steps.responses, steps.laws);
}

results::StepLaw step_law_of(const std::string& name) {
  return name == "power"  ? results::StepLaw::power
         : name == "line" ? results::StepLaw::line
                          : results::StepLaw::curve;
}

/// With one delay element or two: as asked for, else two where one does not do. Of a spindle that
/// can be simulated it is tried: two may fit the steps of a cold spindle, and not a warm one.
correction::Model chosen_model(Messages& messages, const SpindleSteps& steps,
                               const StepCorrectionQuestion& q,
                               results::StepCorrectionParts parts) {
  const spindle::StepResponses& responses = steps.responses;
  if (q.lags != "auto") {
    parts.two_lags = q.lags == "two";
    return results::step_model(responses, parts);
  }
  if (!spindle::need_two(responses.steps)) return results::step_model(responses, parts);
  correction::Model one = results::step_model(responses, parts);
  parts.two_lags = true;
  correction::Model two = results::step_model(responses, parts);
  const model::Model* const model = steps.model();
  if (!model || !model->spindle || !steps.simulated) return two;
  const record::Record trial = results::trial_programme(parts.power.back().speed);
  const results::Superposition of_one =
      results::superposition(*model, one, trial, conditions_of(steps), q.cancelled);
  const results::Superposition of_two =
      results::superposition(*model, two, trial, conditions_of(steps), q.cancelled);
  if (!of_one.report.converged()) return two;
  messages.say(record::note::assumed(
      fmt::format("test over {:.0f} h with a new speed every half hour: the RMS error is {:.3g} um "
                  "with one delay element and {:.3g} um with two. The correction has {} delay "
                  "element{}; {} changes this number",
                  trial.values(record::time).back() / one_hour, of_one.rms / um, of_two.rms / um,
                  of_one.rms <= of_two.rms ? "one" : "two", of_one.rms <= of_two.rms ? "" : "s",
                  named(q.wording, "--lags", "lags"))));
  return of_one.rms <= of_two.rms ? one : two;
}

/// Steps of loads at their speeds; 0 N is left out with a note.
void add_load_steps(Messages& messages, const model::Model& model, const StepQuestion& question,
                    const std::vector<double>& speeds, const spindle::StepOptions& options,
                    spindle::StepResponses& responses) {
  const auto add = [&](spindle::Stepped stepped, std::vector<double> loads,
                       const std::string& key) {
    if (std::erase(loads, 0.0) > 0)
      messages.say(
          record::note::left_out(key + ": 0 N is not a load step and is not used", {.key = key}));
    if (loads.empty()) return;
    for (spindle::LoadSteps& at :
         spindle::load_step_responses(model, stepped, speeds, loads, options))
      responses.loads.push_back(std::move(at));
  };
  add(spindle::Stepped::axial_load, question.axial_loads,
      named(question.wording, "--axial-load", "axial_load_N"));
  add(spindle::Stepped::radial_load, question.radial_loads,
      named(question.wording, "--radial-load", "radial_load_N"));
}

/// Speeds of the steps of loads.
const std::vector<double>& speeds_of_loads(const StepQuestion& question) {
  return question.load_speeds.empty() ? question.speeds : question.load_speeds;
}

std::string name_of_model(const SpindleSteps& steps) {
  const model::Model* const model = steps.model();
  if (!model) return steps.source;
  if (model->spindle && !model->spindle->name.empty()) return model->spindle->name;
  return model->name.empty() ? steps.source : model->name;
}

}  // namespace

SpindleSteps simulated_steps(Messages& messages, const files::ModelFile& file,
                             const StepQuestion& question) {
  const std::string key = named(question.wording, "--speed", "speed_rpm");
  std::vector<double> speeds = question.speeds;
  if (!speeds.empty() && speeds.front() == 0.0) {
    messages.say(record::note::left_out(
        key + ": 0 rpm is not used, because each step starts from rest", {.key = key}));
    speeds.erase(speeds.begin());
  }
  constexpr std::size_t most = 1000;
  if (speeds.empty() || speeds.size() > most)
    throw text::InputError(
        fmt::format("raceway step-response: {} speeds above 0 rpm are given; must be from 1 to {}",
                    speeds.size(), most),
        {.key = key});
  const std::string load_key = named(question.wording, "--load-speed", "load_speed_rpm");
  std::vector<double> load_speeds = speeds_of_loads(question);
  std::erase(load_speeds, 0.0);
  if (!question.load_speeds.empty() && question.axial_loads.empty() &&
      question.radial_loads.empty())
    throw text::InputError(
        "raceway step-response: " + load_key +
            ": no load step is given for these speeds: give an axial or a radial load",
        {.key = load_key});
  for (const double speed : speeds) require_possible_speed(file.model, speed, key);
  for (const double speed : load_speeds) require_possible_speed(file.model, speed, load_key);
  messages.say(said_of(judge_speeds(file.model, speeds)));
  messages.say(states_not_counted(file.model));
  if (const std::string unused = unused_coolant_off(file.model, question.coolant_on, true);
      !unused.empty())
    messages.say(record::note::unused(unused, {.key = "coolant_on"}));
  SpindleSteps steps{
      .file = file, .source = file.source, .coolant_on = question.coolant_on, .simulated = true};
  spindle::StepOptions options{.duration = question.duration, .cancelled = question.cancelled};
  options.inputs = conditions_of(steps);
  steps.responses = spindle::step_responses(file.model, speeds, options);
  add_load_steps(messages, file.model, question, load_speeds, options, steps.responses);
  add_laws(steps);
  return steps;
}

SpindleSteps imported_steps(const std::vector<files::LoadCase>& cases, const std::string& source,
                            const files::ModelFile* file, double temperature_C) {
  SpindleSteps steps{.source = source, .temperature_C = temperature_C};
  if (file) steps.file = *file;
  const model::Model* const model = steps.model();
  steps.responses.steps = files::fit_load_cases(cases);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    spindle::StepResponse& step = steps.responses.steps[k];
    if (!std::isnan(step.power_end)) continue;
    if (!model)
      throw text::InputError(fmt::format("{}: load case {} has a speed but no power: give power_W, "
                                         "or name a MODEL whose friction gives the power",
                                         cases[k].place.text(), cases[k].name),
                             cases[k].place);
    step.power_start = step.power_end = friction_power(*model, step.speed, temperature_C);
  }
  const bool at_once = std::any_of(cases.begin(), cases.end(),
                                   [](const files::LoadCase& c) { return c.at_once != 0.0; });
  if (model && !at_once)
    for (spindle::StepResponse& step : steps.responses.steps)
      if (!std::isnan(step.speed)) step.kinematic = kinematic_at(*model, step.speed);
  add_laws(steps);
  return steps;
}

std::vector<std::string> load_channels(const StepQuestion& question) {
  std::vector<std::string> names;
  for (const auto& [stepped, loads] :
       {std::pair{spindle::Stepped::axial_load, &question.axial_loads},
        std::pair{spindle::Stepped::radial_load, &question.radial_loads}})
    if (!loads->empty())
      for (const double speed : speeds_of_loads(question))
        names.push_back(results::load_channel(stepped, speed));
  return names;
}

std::size_t SpindleSteps::count() const {
  std::size_t count = responses.steps.size();
  for (const spindle::LoadSteps& at : responses.loads) count += at.steps.size();
  return count;
}

bool SpindleSteps::converged() const { return warnings().empty(); }

std::vector<record::Note> SpindleSteps::warnings() const {
  std::vector<record::Note> list;
  const auto see = [&](const spindle::StepResponse& step) {
    if (!step.converged())
      list.push_back(
          record::note::not_converged(fmt::format("{}: {}", name_of(step), step.message)));
  };
  std::for_each(responses.steps.begin(), responses.steps.end(), see);
  for (const spindle::LoadSteps& at : responses.loads)
    std::for_each(at.steps.begin(), at.steps.end(), see);
  return list;
}

std::string SpindleSteps::csv() const {
  return results::step_responses_text(responses, source, file ? file->text : "");
}

std::string SpindleSteps::json(const results::Superposition* error) const {
  return results::step_responses_json(responses, laws, notes, error);
}

std::string SpindleSteps::page(const results::Superposition* error,
                               const std::string& programme) const {
  std::vector<report::ModelOfPage> facts;
  if (file) facts.push_back(of_page(*file, file->model));
  return report::step_report(source, responses, laws, notes, error, programme, facts);
}

correction::Model correction_of_steps(Messages& messages, const SpindleSteps& steps,
                                      const StepCorrectionQuestion& question) {
  const StepParts parts = step_parts(steps.responses, steps.model(), steps.temperature_C);
  messages.say(notes_of(record::note::assumed, parts.notes));
  return chosen_model(messages, steps, question,
                      {.name = name_of_model(steps),
                       .power = parts.power,
                       .kinematic = parts.kinematic,
                       .law = step_law_of(question.law)});
}

results::Superposition superposition_of_steps(Messages& messages, const SpindleSteps& steps,
                                              const correction::Model& correction,
                                              const Source& programme,
                                              const std::atomic<bool>* cancelled) {
  if (!steps.model() || !steps.model()->spindle)
    throw std::invalid_argument(
        "the step responses come without the model of a spindle, which the simulation needs");
  const model::Model& model = *steps.model();
  const record::Record record =
      files::read_spindle_record(programme, *model.spindle, {.columns = steps.file->columns});
  messages.say(record.notes);
  return results::superposition(model, correction, record, conditions_of(steps), cancelled);
}

}  // namespace raceway::session
