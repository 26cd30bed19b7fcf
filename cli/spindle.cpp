#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/output_flags.h"
#include "cli/spindle_text.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "session/spindle_deflection.h"
#include "session/spindle_run.h"
#include "session/spindle_steady.h"
#include "text/error.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct SpindleFlags : ResultFlags {
  std::string model, profile, speed, start, end_state, field;
  bool steady = false, coolant_on = true, assumptions = false;
  double ambient = unset;
  double axial_load_N = unset, radial_load_N = 0.0, moment_Nm = 0.0, belt_force_N = unset;
  double motor_power_W = unset;
  session::Reading reading;

  /// True if the assumptions that matter most are printed; they take six steady states for each
  /// assumed number.
  [[nodiscard]] bool tells_assumptions() const {
    return assumptions || (!json && output != "-") || !report.path.empty();
  }
};

void check_flags(const SpindleFlags& f) {
  const auto fail = [](const std::string& why, const char* flag) {
    throw text::InputError("raceway spindle: " + why, {.key = flag});
  };
  if (f.profile.empty() == f.speed.empty())
    fail("give either --speed-profile, or --speed with --steady", "--speed");
  if (!f.speed.empty() && !f.steady)
    fail("--speed needs --steady; for a simulation over time, use --speed-profile", "--steady");
  if (f.steady && !f.profile.empty())
    fail(
        "--steady needs --speed instead of --speed-profile, because a steady state does not change "
        "over time",
        "--steady");
  const bool loads = !std::isnan(f.axial_load_N) || f.radial_load_N != 0.0 || f.moment_Nm != 0.0 ||
                     !std::isnan(f.belt_force_N) || !std::isnan(f.motor_power_W);
  if (!f.steady && loads)
    fail(
        "--axial-load, --radial-load, --moment, --belt-force and --motor-power need --steady; with "
        "--speed-profile, use columns of the file",
        "--radial-load");
  if (f.steady && !f.start.empty())
    fail("--start: a steady state does not depend on a start state; remove --start or --steady",
         "--start");
  if (f.steady && (!f.reading.columns.empty() || f.reading.drop_nan))
    fail("--columns and --drop-nan are only possible with --speed-profile",
         f.reading.drop_nan ? "--drop-nan" : "--columns");
  f.check_results("spindle");
  f.csv.require_writable(f.field, f.if_exists());
  if (!f.end_state.empty() && f.end_state != "-")
    text::require_writable(f.end_state, f.if_exists());
}

/// The end of a run or of a steady state, into the files asked for.
template <typename Found>
void put_ends(const SpindleFlags& f, const Found& found, const spindle::State& end) {
  if (f.end_state == "-") {
    fmt::print("{}", found.end_state());
  } else if (!f.end_state.empty()) {
    text::write_text(f.end_state, found.end_state(), f.if_exists());
    say(fmt::format("{} written, {} temperatures", f.end_state, end.temperatures.size()));
  }
  f.csv.put(f.field, f.field.empty() ? std::string() : found.field_csv(), f.if_exists(),
            fmt::format(", {} cells", found.field.size()));
}

double ambient_of(const SpindleFlags& f) {
  return std::isnan(f.ambient) ? unset : kelvin(f.ambient);
}

int run_steady(const SpindleFlags& f, const files::ModelFile& file) {
  session::SteadyQuestion question{.speeds = axis(f.speed, speed_range, "--speed"),
                                   .ambient_temperature = ambient_of(f),
                                   .coolant_on = f.coolant_on,
                                   .axial_load = f.axial_load_N,
                                   .radial_load = f.radial_load_N,
                                   .moment = f.moment_Nm,
                                   .belt_force = f.belt_force_N,
                                   .motor_power = f.motor_power_W,
                                   .assumptions = f.tells_assumptions()};
  require_all(question.speeds, speed_range, "--speed");
  for (double& speed : question.speeds) speed *= rpm;
  if ((!f.field.empty() || !f.end_state.empty()) && question.speeds.size() > 1)
    throw text::InputError(
        "raceway spindle: --field and --end-state need a single --speed, because each file "
        "contains one state",
        {.key = "--speed"});
  const session::SteadySpindle found = session::steady_spindle(file, question);
  const std::size_t count = found.states.size();
  f.put_table([&] { return found.csv(); },
              fmt::format(", {} speed{}", count, count == 1 ? "" : "s"));
  if (found.states.back().report.converged()) put_ends(f, found, found.end);
  if (f.json)
    put_document(found.json(f.assumptions));
  else if (f.output != "-")
    print_steady(found);
  return f.finish(found);
}

int run_profile(const SpindleFlags& f, const files::ModelFile& file) {
  session::RunQuestion question{.programme = f.profile,
                                .reading = f.reading,
                                .ambient_temperature = ambient_of(f),
                                .coolant_on = f.coolant_on,
                                .mesh = f.json || f.output != "-" || !f.report.path.empty(),
                                .assumptions = f.tells_assumptions()};
  if (!f.start.empty()) question.start = f.start;
  const session::SpindleRun found = session::simulate_spindle(messages(), file, question);
  f.put_table([&] { return found.csv(); }, fmt::format(", {} rows", found.run.moments.size()));
  put_ends(f, found, found.run.end);
  if (f.json)
    put_document(found.json(f.assumptions));
  else if (f.output != "-")
    print_run(found);
  return f.finish(found);
}

int run(const SpindleFlags& flags) {
  check_flags(flags);
  const files::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  session::require_spindle(file);
  return flags.steady ? run_steady(flags, file) : run_profile(flags, file);
}

}  // namespace

Run setup_spindle(CLI::App& command) {
  auto flags = std::make_shared<SpindleFlags>();
  declare_model(command, flags->model, "[shaft] and [housing]");
  command
      .add_option("--speed-profile", flags->profile,
                  "CSV with time_s, speed_rpm and, if known, coolant_on, ambient_temperature_C, "
                  "machine_temperature_C, coolant_inlet_temperature_C, axial_load_N, "
                  "radial_load_N, moment_Nm, belt_force_N, motor_heat_W, motor_power_W; "
                  "settings_hold under [columns] of MODEL defines whether the settings of a row "
                  "apply until the next row or from the previous row")
      ->type_name("FILE");
  command
      .add_option("--speed", flags->speed,
                  "speeds [rpm], such as 6000 or a range from:to:step; needs --steady")
      ->type_name("VALUES");
  command.add_flag("--steady", flags->steady, "calculate the steady state at each --speed");
  declare_coolant(command, flags->coolant_on,
                  "coolant on or off; off switches the coolant off in all rows");
  add_number(command, "--ambient", flags->ambient, temperature_range,
             "air temperature in all rows [C]; default: column ambient_temperature_C, else "
             "[ambient] of the model");
  add_number(command, "--axial-load", flags->axial_load_N, signed_load_range,
             "axial load at the nose [N], positive towards the tool; needs --steady; default: "
             "external_load_N of the model");
  add_number(command, "--radial-load", flags->radial_load_N, signed_load_range,
             "radial load at the nose [N]; needs --steady; default 0");
  add_number(command, "--moment", flags->moment_Nm, session::moment_load_range,
             "moment at the nose [N m]; a positive moment turns the shaft like a positive "
             "radial load in front of the nose; needs --steady");
  add_number(command, "--belt-force", flags->belt_force_N, load_range,
             "belt force [N]; needs --steady; default: belt_force_N under [drive] of the model");
  add_number(command, "--motor-power", flags->motor_power_W, power_range,
             "motor power [W], for heat formulas with motor_power_W; needs --steady");
  flags->declare_output(
      command, "CSV file to write, - for stdout: displacement, forces, heat and temperatures");
  command
      .add_option("--start", flags->start,
                  "start state, a file written by --end-state; default: the whole spindle at room "
                  "temperature")
      ->type_name("FILE");
  command
      .add_option("--end-state", flags->end_state,
                  "file for the temperatures at the end of the run (JSON)")
      ->type_name("FILE");
  command
      .add_option("--field", flags->field,
                  "file for the temperature of each cell at the end of the run (CSV)")
      ->type_name("FILE");
  declare(command, flags->reading);
  command.add_flag("--assumptions", flags->assumptions,
                   "with --json: also write at most five assumed numbers with the largest "
                   "influence on the nose displacement");
  flags->declare_results(command);
  command.footer(
      "Examples:\n  raceway spindle my.toml --speed 6000 --steady\n"
      "  raceway spindle my.toml --speed-profile day.csv -o run.csv --report page.html");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
