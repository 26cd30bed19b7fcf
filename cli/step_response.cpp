#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/number_flag.h"
#include "cli/output_flags.h"
#include "cli/run_files.h"
#include "cli/step_correction.h"
#include "cli/step_response_text.h"
#include "files/step_import.h"
#include "results/superposition.h"
#include "session/open_input.h"
#include "session/spindle_steps.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

constexpr double one_hour = 3600.0;

struct StepFlags : ResultFlags {
  std::string model, speed, axial_load, radial_load, load_speed, import, units = "s,um";
  StepCorrectionFlags correction;
  std::vector<std::string> load_cases;
  double hours = 4.0, temperature = unset;
  bool coolant_on = true;

  [[nodiscard]] bool imports() const { return !import.empty() || !load_cases.empty(); }
  [[nodiscard]] bool steps_loads() const { return !axial_load.empty() || !radial_load.empty(); }
};

void check_step_flags(const StepFlags& f) {
  const auto refuse = [](const std::string& why, const std::string& key) {
    throw text::InputError("raceway step-response: " + why, {.key = key});
  };
  if (f.imports() && !f.speed.empty())
    refuse(
        "--speed simulates step responses, but --import and --load-case read step responses; "
        "choose one of these flags",
        "--speed");
  if (f.imports() && (f.steps_loads() || !f.load_speed.empty()))
    refuse(
        "--axial-load and --radial-load simulate load steps, but --import and --load-case read "
        "step responses; choose one",
        f.steps_loads() ? f.axial_load.empty() ? "--radial-load" : "--axial-load" : "--load-speed");
  if (!f.imports() && f.model.empty())
    refuse("give MODEL or --import FILE or --load-case LOAD=FILE", "MODEL");
  if (!f.imports() && f.speed.empty())
    refuse("give --speed, such as 2000:10000:2000, or --import FILE or --load-case LOAD=FILE",
           "--speed");
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
          .coolant_on = flags.coolant_on,
          .wording = session::Wording::flags};
}

int run(const StepFlags& flags) {
  check_step_flags(flags);
  const session::StepQuestion question = step_question(flags);
  flags.check_results("step-response");
  flags.correction.require_writable(flags.if_exists(), session::load_channels(question));
  std::optional<files::ModelFile> file;
  if (!flags.model.empty())
    file = session::open_model(messages(), flags.model, session::Accepts::shaft);
  const session::SpindleSteps steps = flags.imports()
                                          ? imported_steps(flags, file ? &*file : nullptr)
                                          : session::simulated_steps(messages(), *file, question);
  flags.put_table([&] { return steps.csv(); }, fmt::format(", {} step responses", steps.count()));
  if (!flags.json && flags.output.empty()) print_steps(steps);
  tell(steps.notes);
  flags.correction.write(steps, flags.force);
  std::optional<results::Superposition> error;
  if (steps.file) error = flags.correction.superposition(steps);
  if (flags.json) put_document(steps.json(error ? &*error : nullptr));
  flags.put_page([&] { return steps.page(error ? &*error : nullptr, flags.correction.programme); });
  tell(steps.warnings());
  return steps.converged() && (!error || error->report.converged()) ? done : not_converged;
}

}  // namespace

Run setup_step_response(CLI::App& command) {
  auto flags = std::make_shared<StepFlags>();
  command
      .add_option("MODEL", flags->model,
                  "model file (TOML) of a spindle; with --import, of any shaft")
      ->type_name("");
  command
      .add_option("--speed", flags->speed,
                  "speeds of the steps [rpm]: a list such as 2000,6000 or a range from:to:step "
                  "such as 2000:10000:2000")
      ->type_name("VALUES");
  command
      .add_option("--axial-load", flags->axial_load,
                  "axial load steps at the spindle nose [N], applied in the steady state at each "
                  "speed; positive towards the tool, such as --axial-load=-500,500")
      ->type_name("VALUES");
  command
      .add_option("--radial-load", flags->radial_load, "radial load steps at the spindle nose [N]")
      ->type_name("VALUES");
  command
      .add_option("--load-speed", flags->load_speed,
                  "speeds of the load steps [rpm]; default: all of --speed")
      ->type_name("VALUES");
  add_number(command, "--hours", flags->hours, session::step_hours_range,
             "duration of each step [h]; default 4");
  declare_coolant(command, flags->coolant_on, "coolant, on or off; default on");
  command
      .add_option("--import", flags->import,
                  "CSV with load_case, time_s, axial_displacement_um, and power_W or\nspeed_rpm")
      ->type_name("FILE");
  command
      .add_option("--load-case", flags->load_cases,
                  "power or speed of a step, and file with two columns, time and displacement, "
                  "such as 50W=a.csv or 6000rpm=b.csv; repeat the flag for each file")
      ->type_name("LOAD=FILE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--units", flags->units,
                  "units of time and displacement in the time histories; default s,um")
      ->type_name("TIME,LENGTH");
  add_number(command, "--temperature", flags->temperature, temperature_range,
             "lubricant temperature [C] for the friction power of imported speeds; default: [rig] "
             "of MODEL, else 40");
  flags->declare_output(command, "CSV file to write; - for stdout");
  flags->correction.declare(command);
  for (const char* const simulated : {"--hours", "--coolant"})
    command.get_option(simulated)->needs("--speed");
  command.get_option("--temperature")->excludes("--speed");
  command.get_option("--units")->needs("--load-case");
  flags->declare_results(command);
  command.footer(
      "Example:\n  raceway step-response spindle.toml --speed 2000:10000:2000 -o steps.csv\n"
      "  raceway step-response --load-case 50W=a.csv --load-case 100W=b.csv --json");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
