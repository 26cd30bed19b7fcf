#include "spindle/step_response.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/report_flag.h"
#include "cli/run_files.h"
#include "cli/step_parts.h"
#include "cli/text_table.h"
#include "io/correction_file.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/series_file.h"
#include "io/step_correction.h"
#include "io/step_import.h"
#include "io/step_report.h"
#include "io/step_results.h"
#include "io/superposition.h"
#include "session/open_input.h"

namespace raceway::cli {
namespace {

constexpr double one_hour = 3600.0;
constexpr NumberRange step_hours_range{0.1, 1000.0, "h"};

struct StepFlags {
  std::string model, speed, import, output, correction, programme, law = "curve", lags = "auto",
                                                                   units = "s,um", coolant = "on";
  std::vector<std::string> load_cases;
  double hours = 4.0, row = 120.0, temperature = unset;
  bool json = false, force = false;
  ReportFlag report;

  [[nodiscard]] bool imports() const { return !import.empty() || !load_cases.empty(); }
};

spindle::Inputs inputs_of(const StepFlags& flags) {
  spindle::Inputs inputs;
  inputs.coolant_on = flags.coolant == "on";
  return inputs;
}

void check_step_flags(const StepFlags& f) {
  const auto refuse = [](const std::string& why, const std::string& key) {
    throw io::InputError("raceway step-response: " + why, {.key = key});
  };
  if (f.json && f.output == "-")
    refuse("--json and --output - both write to stdout; take one", "--output");
  if (f.imports() && !f.speed.empty())
    refuse("--speed simulates and --import reads step responses; take one", "--speed");
  if (!f.imports() && f.model.empty()) refuse("MODEL is missing, or --import FILE", "MODEL");
  if (!f.imports() && f.speed.empty())
    refuse("--speed is missing, such as 2000:10000:2000, or --import FILE", "--speed");
  if (!f.programme.empty() && (f.correction.empty() || f.model.empty()))
    refuse("--programme holds a correction against the simulation of MODEL: name --correction FILE",
           "--programme");
  if (f.correction == "-")
    refuse("--correction -: has tables beside it; name a file", "--correction");
}

/// Step responses from files, with the power of those that have a speed alone.
spindle::StepResponses imported_steps(const StepFlags& flags, const model::Model* model) {
  std::vector<io::LoadCase> cases;
  if (!flags.import.empty()) cases = io::read_load_cases(flags.import);
  const io::HistoryUnits units = io::history_units(flags.units, "--units");
  for (const std::string& given : flags.load_cases) {
    const std::size_t equals = given.find('=');
    if (equals != given.npos) add_input(given.substr(equals + 1));
    cases.push_back(io::read_history(given, units));
  }
  spindle::StepResponses responses{.steps = io::fit_load_cases(cases)};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    spindle::StepResponse& step = responses.steps[k];
    if (!std::isnan(step.power_end)) continue;
    if (!model)
      throw io::InputError(
          fmt::format("{}: load case {}: has a speed and no power, which follows from the friction "
                      "of a model: name the MODEL, or give power_W",
                      cases[k].place.text(), cases[k].name),
          cases[k].place);
    step.power_start = step.power_end = friction_power(*model, step.speed, flags.temperature);
  }
  const bool at_once = std::any_of(cases.begin(), cases.end(),
                                   [](const io::LoadCase& c) { return c.at_once != 0.0; });
  if (model && !at_once)
    for (spindle::StepResponse& step : responses.steps)
      if (!std::isnan(step.speed)) step.kinematic = kinematic_at(*model, step.speed);
  return responses;
}

spindle::StepResponses simulated_steps(const StepFlags& flags, const model::Model& model) {
  std::vector<double> speeds = axis(flags.speed, "--speed");
  require_all(speeds, speed_range, "--speed");
  if (speeds.front() == 0.0) {
    tell({"--speed: 0 rpm is rest, where each step begins: left out"});
    speeds.erase(speeds.begin());
  }
  constexpr std::size_t most = 1000;
  if (speeds.empty() || speeds.size() > most)
    throw io::InputError(
        fmt::format("raceway step-response: {} speeds above 0 rpm: must be from 1 to {}",
                    speeds.size(), most),
        {.key = "--speed"});
  for (double& speed : speeds) speed *= rpm;
  spindle::StepOptions options{.duration = flags.hours * one_hour, .row = flags.row};
  options.inputs = inputs_of(flags);
  return spindle::step_responses(model, speeds, options);
}

std::vector<std::string> notes_on_steps(const spindle::StepResponses& responses,
                                        const spindle::PowerLaws& laws) {
  std::vector<std::string> notes;
  std::size_t two = 0;
  for (const spindle::StepResponse& step : responses.steps) {
    two += step.fit.two_needed ? 1 : 0;
    if (step.converged() && !step.fit.settled)
      notes.push_back(fmt::format(
          "{}: a time constant of {:.3g} min is more than half of what was seen: gain and time "
          "constant are a guess",
          name_of(step), step.fit.one.time_constant / spindle::one_minute));
  }
  if (two > 0)
    notes.push_back(fmt::format("{} of {} step responses need two time constants", two,
                                responses.steps.size()));
  if (!std::isnan(laws.gain_line.offset))
    notes.push_back(fmt::format(
        "the lines are chords: K(0) = {} um of theirs is no physics; {} to {} W is where K and T "
        "keep their sign",
        number(laws.gain_line.offset / um, 3), number(laws.valid_from),
        std::isinf(laws.valid_to) ? std::string("any") : number(laws.valid_to)));
  return notes;
}

void print_steps(const spindle::StepResponses& responses, const spindle::PowerLaws& laws,
                 const std::string& source) {
  fmt::print("Step responses of {}: u = kinematic + K (1 - exp(-t/T)), P at the end\n\n", source);
  TextTable table({{"step", "", true},
                   {"power", "W"},
                   {"kinematic", "um"},
                   {"K", "um"},
                   {"T", "min"},
                   {"left", "um"},
                   {"K1", "um"},
                   {"T1", "min"},
                   {"K2", "um"},
                   {"T2", "min"},
                   {"left", "um"}});
  for (const spindle::StepResponse& s : responses.steps) {
    const spindle::StepFit& f = s.fit;
    table.add({name_of(s), number(s.power_end), number(s.kinematic / um), number(f.one.gain / um),
               number(f.one.time_constant / spindle::one_minute), number(f.rms / um, 2),
               number(f.fast.gain / um), number(f.fast.time_constant / spindle::one_minute, 3),
               number(f.slow.gain / um), number(f.slow.time_constant / spindle::one_minute, 3),
               number(f.rms_of_two / um, 2)});
  }
  fmt::print("{}", table.text(terminal_width()));
  if (responses.cool_down.known())
    fmt::print("back to rest from the fastest: T = {} min\n",
               number(responses.cool_down.one / spindle::one_minute));
  if (std::isnan(laws.gain_line.slope)) return;
  fmt::print("\nK = {} um/W P + {} um, T = {} min/W P + {} min\n",
             number(laws.gain_line.slope / um), number(laws.gain_line.offset / um),
             number(laws.time_line.slope / spindle::one_minute),
             number(laws.time_line.offset / spindle::one_minute));
  if (!std::isnan(laws.gain_power.exponent))
    fmt::print("K = {} um (P/W)^{}, T = {} min (P/W)^{}\n", number(laws.gain_power.factor / um),
               number(laws.gain_power.exponent),
               number(laws.time_power.factor / spindle::one_minute),
               number(laws.time_power.exponent));
}

io::StepLaw step_law_of(const std::string& name) {
  return name == "power"  ? io::StepLaw::power
         : name == "line" ? io::StepLaw::line
                          : io::StepLaw::curve;
}

/// With one delay element or two: as asked for, else two where one does not do. Of a spindle that
/// can be simulated it is tried: two may fit the steps of a cold spindle, and not a warm one.
correction::Model chosen_model(const StepFlags& flags, const spindle::StepResponses& responses,
                               const model::Model* model, io::StepCorrectionParts parts) {
  if (flags.lags != "auto") {
    parts.two_lags = flags.lags == "two";
    return io::step_model(responses, parts);
  }
  if (!spindle::need_two(responses.steps)) return io::step_model(responses, parts);
  correction::Model one = io::step_model(responses, parts);
  parts.two_lags = true;
  correction::Model two = io::step_model(responses, parts);
  if (!model || !model->spindle || flags.imports()) return two;
  const record::Record trial = io::trial_programme(parts.power.back().speed);
  const io::Superposition of_one = io::superposition(*model, one, trial, inputs_of(flags));
  const io::Superposition of_two = io::superposition(*model, two, trial, inputs_of(flags));
  if (!of_one.report.converged()) return two;
  tell(
      {fmt::format("over {:.0f} h of half hours at several speeds one delay element is off by "
                   "{:.3g} um rms, two by {:.3g}: {} written; --lags says other",
                   trial.values(record::time).back() / one_hour, of_one.rms / um, of_two.rms / um,
                   of_one.rms <= of_two.rms ? "one" : "two")});
  return of_one.rms <= of_two.rms ? one : two;
}

std::string name_of_model(const model::Model* model, const std::string& source) {
  if (!model) return source;
  if (model->spindle && !model->spindle->name.empty()) return model->spindle->name;
  return model->name.empty() ? source : model->name;
}

void write_correction_of(const StepFlags& flags, const spindle::StepResponses& responses,
                         const model::Model* model, const std::string& source) {
  const StepParts parts = step_parts(responses, model, flags.temperature);
  tell(parts.notes);
  try {
    const io::StepCorrection written =
        io::step_correction(chosen_model(flags, responses, model,
                                         {.name = name_of_model(model, source),
                                          .power = parts.power,
                                          .kinematic = parts.kinematic,
                                          .law = step_law_of(flags.law)}),
                            flags.correction);
    io::write_step_correction(written, flags.correction, flags.force);
    std::string tables;
    for (const auto& [file, text] : written.tables) tables += (tables.empty() ? "" : ", ") + file;
    say(fmt::format("{} written, with {}", flags.correction, tables));
  } catch (const std::invalid_argument& e) {
    throw io::InputError(fmt::format("raceway step-response: --correction: {}", e.what()),
                         {.key = "--correction"});
  }
}

/// The correction as it was written against the whole simulation, over a programme of speeds.
std::optional<io::Superposition> superposition_of(const StepFlags& flags,
                                                  const model::Model& model) {
  if (flags.programme.empty()) return std::nullopt;
  const io::CorrectionFile written = io::read_correction(flags.correction);
  const record::Record programme =
      io::read_series(flags.programme, {}, {&record::time, &record::speed});
  io::Superposition s =
      io::superposition(model, written.models.front(), programme, inputs_of(flags));
  if (s.report.converged())
    say(fmt::format("over {} the correction differs from the simulation by {}", flags.programme,
                    io::superposition_text(s)));
  else
    warn(fmt::format("{}: the simulation ended early: {}", flags.programme, s.report.message));
  return s;
}

void require_step_files(const StepFlags& flags) {
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (!flags.output.empty() && flags.output != "-") io::require_writable(flags.output, if_exists);
  flags.report.check(flags.force);
  if (flags.correction.empty()) return;
  const std::vector<std::string> tables = io::step_correction_tables(flags.correction);
  check_outputs(tables);
  io::require_writable(flags.correction, if_exists);
  for (const std::string& table : tables) io::require_writable(table, if_exists);
}

int run(const StepFlags& flags) {
  check_step_flags(flags);
  require_step_files(flags);
  std::optional<io::ModelFile> file;
  if (!flags.model.empty())
    file = session::open_model(messages(), flags.model, session::Accepts::shaft);
  const model::Model* const model = file ? &file->model : nullptr;
  const spindle::StepResponses responses =
      flags.imports() ? imported_steps(flags, model) : simulated_steps(flags, *model);
  const spindle::PowerLaws laws = spindle::fit_power_laws(at_powers(responses.steps));
  const std::string source = !flags.imports()       ? file->source
                             : flags.import.empty() ? "time histories"
                                                    : flags.import;
  const std::vector<std::string> notes = notes_on_steps(responses, laws);
  if (!flags.output.empty()) {
    const std::string csv = io::step_responses_text(responses, source, file ? file->text : "");
    if (flags.output == "-") {
      fmt::print("{}", csv);
    } else {
      io::write_text(flags.output, csv, flags.force ? io::IfExists::replace : io::IfExists::refuse);
      say(fmt::format("{} written, {} step responses", flags.output, responses.steps.size()));
    }
  }
  if (!flags.json && flags.output.empty()) print_steps(responses, laws, source);
  tell(notes);
  if (!flags.correction.empty()) write_correction_of(flags, responses, model, source);
  std::optional<io::Superposition> error;
  if (model) error = superposition_of(flags, *model);
  if (flags.json)
    put_document(io::step_responses_json(responses, laws, notes, error ? &*error : nullptr));
  flags.report.write(
      [&] {
        std::vector<io::ModelOfPage> facts;
        if (file) facts.push_back(session::of_page(*file, *model));
        return io::step_report(source, responses, laws, notes, error ? &*error : nullptr,
                               flags.programme, facts);
      },
      flags.force);
  bool all = !error || error->report.converged();
  for (const spindle::StepResponse& step : responses.steps) {
    if (step.converged()) continue;
    warn(fmt::format("{}: {}", name_of(step), step.message));
    all = false;
  }
  return all ? done : not_converged;
}

}  // namespace

Run setup_step_response(CLI::App& command) {
  auto flags = std::make_shared<StepFlags>();
  command
      .add_option("MODEL", flags->model, "model file (TOML) of a spindle; with --import any shaft")
      ->type_name("");
  command
      .add_option("--speed", flags->speed,
                  "[rpm] of the steps, as 2000,6000 or as from:to:step, 2000:10000:2000")
      ->type_name("VALUES");
  add_number(command, "--hours", flags->hours, step_hours_range, "of each step; default 4");
  command.add_option("--coolant", flags->coolant, "on or off; default on")
      ->check(CLI::IsMember({"on", "off"}))
      ->type_name("STATE");
  command
      .add_option("--import", flags->import,
                  "CSV with load_case, time_s, axial_displacement_um, and power_W or\nspeed_rpm")
      ->type_name("FILE");
  command
      .add_option("--load-case", flags->load_cases,
                  "a time history of two columns with its load, 50W=a.csv; again for each")
      ->type_name("LOAD=FILE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--units", flags->units, "of time histories; default s,um")
      ->type_name("TIME,LENGTH");
  add_number(
      command, "--temperature", flags->temperature, temperature_range,
      "of the lubricant [C], for the power at imported speeds;\ndefault: [rig] of MODEL, else 40");
  command.add_option("-o,--output", flags->output, "CSV file to write; - for stdout")
      ->type_name("FILE");
  command
      .add_option("--correction", flags->correction,
                  "model of a correction to write, with its tables beside it")
      ->type_name("FILE");
  command.add_option("--law", flags->law, "of K and T in the correction: curve, power or line")
      ->check(CLI::IsMember({"curve", "power", "line"}))
      ->type_name("LAW");
  command
      .add_option("--lags", flags->lags,
                  "delay elements of the correction: one, two or auto (default)")
      ->check(CLI::IsMember({"one", "two", "auto"}))
      ->type_name("NUMBER");
  command
      .add_option("--programme", flags->programme,
                  "CSV with time_s, speed_rpm: the correction against the simulation")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace files that exist");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.footer(
      "Example:\n  raceway step-response spindle.toml --speed 2000:10000:2000 -o steps.csv\n"
      "  raceway step-response --load-case 50W=a.csv --load-case 100W=b.csv --json");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
