#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/csv_style.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/report_flag.h"
#include "cli/run_files.h"
#include "cli/shared_flags.h"
#include "cli/step_correction.h"
#include "cli/step_response_text.h"
#include "files/step_import.h"
#include "results/superposition.h"
#include "session/open_input.h"
#include "session/spindle_steps.h"
#include "text/error.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

constexpr double one_hour = 3600.0;

struct StepFlags {
  std::string model, speed, axial_load, radial_load, load_speed, import, output, units = "s,um",
                                                                                 coolant = "on";
  StepCorrectionFlags correction;
  std::vector<std::string> load_cases;
  double hours = 4.0, temperature = unset;
  bool json = false, force = false;
  CsvStyle csv;
  ReportFlag report;

  [[nodiscard]] bool imports() const { return !import.empty() || !load_cases.empty(); }
  [[nodiscard]] bool steps_loads() const { return !axial_load.empty() || !radial_load.empty(); }
};

void check_step_flags(const StepFlags& f) {
  const auto refuse = [](const std::string& why, const std::string& key) {
    throw text::InputError("raceway step-response: " + why, {.key = key});
  };
  refuse_two_on_stdout("step-response", f.json, f.output);
  if (f.imports() && !f.speed.empty())
    refuse("--speed simulates and --import reads step responses; take one", "--speed");
  if (f.imports() && (f.steps_loads() || !f.load_speed.empty()))
    refuse(
        "--axial-load and --radial-load are simulated, and --import reads step responses; take one",
        f.steps_loads() ? f.axial_load.empty() ? "--radial-load" : "--axial-load" : "--load-speed");
  if (!f.imports() && f.model.empty()) refuse("MODEL is missing, or --import FILE", "MODEL");
  if (!f.imports() && f.speed.empty())
    refuse("--speed is missing, such as 2000:10000:2000, or --import FILE", "--speed");
  f.correction.check(!f.model.empty());
}

/// Step responses from files.
session::SpindleSteps imported_steps(const StepFlags& flags, const files::ModelFile* file) {
  std::vector<files::LoadCase> cases;
  if (!flags.import.empty()) cases = files::read_load_cases(flags.import);
  const files::HistoryUnits units = files::history_units(flags.units, "--units");
  for (const std::string& given : flags.load_cases) {
    const std::size_t equals = given.find('=');
    if (equals != given.npos) add_input(given.substr(equals + 1));
    cases.push_back(files::read_history(given, units));
  }
  return session::imported_steps(cases, flags.import.empty() ? "time histories" : flags.import,
                                 file, flags.temperature);
}

std::vector<double> given_axis(const std::string& values, const char* flag,
                               const NumberRange& range, double unit) {
  if (values.empty()) return {};
  std::vector<double> list = axis(values, range, flag);
  require_all(list, range, flag);
  for (double& value : list) value *= unit;
  return list;
}

session::StepQuestion step_question(const StepFlags& flags) {
  return {.speeds = given_axis(flags.speed, "--speed", speed_range, rpm),
          .axial_loads = given_axis(flags.axial_load, "--axial-load", signed_load_range, 1.0),
          .radial_loads = given_axis(flags.radial_load, "--radial-load", signed_load_range, 1.0),
          .load_speeds = given_axis(flags.load_speed, "--load-speed", speed_range, rpm),
          .duration = flags.hours * one_hour,
          .coolant_on = flags.coolant == "on",
          .wording = session::Wording::flags};
}

void require_step_files(const StepFlags& flags, const session::StepQuestion& question) {
  const auto if_exists = on_existing(flags.force);
  flags.csv.require_writable(flags.output, if_exists);
  flags.report.check(flags.force);
  flags.correction.require_writable(if_exists, session::load_channels(question));
}

int run(const StepFlags& flags) {
  check_step_flags(flags);
  const session::StepQuestion question = step_question(flags);
  require_step_files(flags, question);
  std::optional<files::ModelFile> file;
  if (!flags.model.empty())
    file = session::open_model(messages(), flags.model, session::Accepts::shaft);
  const session::SpindleSteps steps = flags.imports()
                                          ? imported_steps(flags, file ? &*file : nullptr)
                                          : session::simulated_steps(messages(), *file, question);
  if (!flags.output.empty())
    flags.csv.put(flags.output, steps.csv(), on_existing(flags.force),
                  fmt::format(", {} step responses", steps.count()));
  if (!flags.json && flags.output.empty()) print_steps(steps);
  tell(steps.notes);
  flags.correction.write(steps, flags.force);
  std::optional<results::Superposition> error;
  if (steps.file) error = flags.correction.superposition(steps);
  if (flags.json) put_document(steps.json(error ? &*error : nullptr));
  flags.report.write(
      [&] { return steps.page(error ? &*error : nullptr, flags.correction.programme); },
      flags.force);
  tell(steps.warnings());
  return steps.converged() && (!error || error->report.converged()) ? done : not_converged;
}

}  // namespace

Run setup_step_response(CLI::App& command) {
  auto flags = std::make_shared<StepFlags>();
  command
      .add_option("MODEL", flags->model, "model file (TOML) of a spindle; with --import any shaft")
      ->type_name("");
  command
      .add_option("--speed", flags->speed,
                  "speeds of the steps [rpm], as 2000,6000 or as from:to:step, 2000:10000:2000")
      ->type_name("VALUES");
  command
      .add_option("--axial-load", flags->axial_load,
                  "axial load of steps at the nose of a spindle in its steady state [N],\npositive "
                  "towards the tool, as --axial-load=-500,500")
      ->type_name("VALUES");
  command.add_option("--radial-load", flags->radial_load, "radial load of such steps [N]")
      ->type_name("VALUES");
  command
      .add_option("--load-speed", flags->load_speed,
                  "speeds of the load steps [rpm]; default: all of --speed")
      ->type_name("VALUES");
  add_number(command, "--hours", flags->hours, session::step_hours_range,
             "duration of each step; default 4");
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
  command.add_option("--units", flags->units, "units of time histories; default s,um")
      ->type_name("TIME,LENGTH");
  add_number(command, "--temperature", flags->temperature, temperature_range,
             "lubricant temperature [C], for the power at imported speeds;\ndefault: [rig] of "
             "MODEL, else 40");
  command.add_option("-o,--output", flags->output, "CSV file to write; - for stdout")
      ->type_name("FILE");
  flags->correction.declare(command);
  for (const char* const simulated : {"--hours", "--coolant"})
    command.get_option(simulated)->needs("--speed");
  command.get_option("--temperature")->excludes("--speed");
  command.get_option("--units")->needs("--load-case");
  flags->csv.declare(command);
  command.add_flag("--force", flags->force, "replace files that exist");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.footer(
      "Example:\n  raceway step-response spindle.toml --speed 2000:10000:2000 -o steps.csv\n"
      "  raceway step-response --load-case 50W=a.csv --load-case 100W=b.csv --json");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
