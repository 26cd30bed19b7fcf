#include "cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "cli/help.h"
#include "cli/messages.h"
#include "cli/parse_problem.h"
#include "cli/run_files.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

struct Command {
  const char* group;  ///< heading in the help; empty for a command that it does not list
  const char* name;
  const char* summary;
  Run (*setup)(CLI::App&);
};

constexpr const char *measure = "Measure and model", *bearing = "Bearing", *machine = "Machine",
                     *sensors = "Sensors", *understand = "Understand", *look_up = "Look up",
                     *spindles = "Shaft and spindle", *hidden = "";

// In the order of the help: what most people need stands first.
constexpr std::array commands{
    Command{measure, "new", "Write a model file of a bearing, a spindle or a correction",
            setup_new},
    Command{measure, "check", "Show how raceway reads data, and which effects the data can show",
            setup_check},
    Command{measure, "compare", "Compare a model with measurements: size and place of the errors",
            setup_compare},
    Command{measure, "calibrate", "Fit the free parameters of a model to measurements",
            setup_calibrate},
    Command{measure, "diagnose", "Find the missing effect, or the measurements to find it",
            setup_diagnose},
    Command{measure, "add", "Add an effect to a model if it reduces the held-out error", setup_add},
    Command{bearing, "solve", "Calculate contact angles, loads, stiffness and friction",
            setup_solve},
    Command{bearing, "table", "Calculate friction torque over speed, loads and temperature",
            setup_table},
    Command{machine, "identify", "Find the thermal lags of a correction in a record over time",
            setup_identify},
    Command{machine, "correct", "Run a correction over a record and predict the displacement",
            setup_correct},
    Command{machine, "export", "Write a correction for a control: Python, C, CSV, LinuxCNC",
            setup_export},
    Command{machine, "step-response",
            "Calculate gains and lags of a spindle from steps of its speed", setup_step_response},
    Command{machine, "fit-law", "Fit a law to a curve of axial displacement over speed",
            setup_fit_law},
    Command{machine, "join", "Join corrections of the same displacement", setup_join},
    Command{sensors, "calibrate-sensor", "Fit the curve of a torque sensor to known torques",
            setup_calibrate_sensor},
    Command{understand, "sensitivity",
            "Rank the numbers of a model by their influence on a prediction", setup_sensitivity},
    Command{understand, "workbench", "Write the workbench, an HTML page that contains this program",
            setup_workbench},
    Command{look_up, "bearings", "List the catalogue of bearings", setup_bearings},
    Command{look_up, "effects", "List the physical effects, or explain one of them", setup_effects},
    Command{look_up, "keys", "List the keys of model files, with unit, default and range",
            setup_keys},
    Command{spindles, "displacement",
            "Calculate shaft position, bearing forces and friction over speed", setup_displacement},
    Command{spindles, "spindle", "Simulate temperatures, preload and displacement of a spindle",
            setup_spindle},
    Command{spindles, "modes", "Calculate natural frequencies of a shaft (Campbell diagram)",
            setup_modes},
    Command{spindles, "deflection", "Calculate the deflection of a shaft under a force",
            setup_deflection},
    Command{hidden, "describe", "Write shell completions and man pages of the commands",
            setup_describe},
};

/// Returns advice on a command with too many or too few words, such as " (write ...)"; may be
/// empty.
std::string advice_on(const CLI::ParseError& problem, std::span<char* const> arguments) {
  if (dynamic_cast<const CLI::ExtrasError*>(&problem))
    return " (write a name with blanks in quotes, as in \"7014 AC\", and a list of values with "
           "commas, as in 100,300)";
  const bool data_alone = std::any_of(arguments.begin(), arguments.end(),
                                      [](std::string_view a) { return a.ends_with(".csv"); }) &&
                          std::none_of(arguments.begin(), arguments.end(),
                                       [](std::string_view a) { return a.ends_with(".toml"); });
  return dynamic_cast<const CLI::RequiredError*>(&problem) && data_alone
             ? " (a model file stands before the measurements)"
             : "";
}

/// With the way to the help of the command.
Refusal of_command_line(const std::string& command, const std::string& problem,
                        const std::string& key) {
  return {fmt::format("{0}: {1}\nTry {0} --help.", command, problem), {.key = key}};
}

}  // namespace

Program::Program() {
  app_.name("raceway");
  app_.set_version_flag("--version", "raceway " RACEWAY_VERSION);
  app_.require_subcommand(1);
  app_.formatter(std::make_shared<HelpFormatter>());
  app_.footer(
      "raceway help COMMAND explains a command. Results go to stdout, messages to\n"
      "stderr; --json prints one JSON document. A file named - is standard input.\n"
      "Exit status: 0 done, 1 wrong input, 2 not converged.\n\n"
      "Example:\n"
      "  raceway new \"S 6014 C\" -o my.toml\n"
      "  raceway table my.toml --speed 0:12000:1000 --axial-load 100,300,900");
  for (const Command& c : commands) {
    CLI::App* command = app_.add_subcommand(c.name, c.summary);
    command->group(c.group);
    runs_[command] = c.setup(*command);
    command->add_flag_callback(
        "--quiet", [] { set_quiet(true); },
        "print only errors: no notes, no warnings, no list of written files");
  }
}

const CLI::App& Program::command(const std::string& name) const {
  std::vector<std::string> names;
  for (const CLI::App* known : app_.get_subcommands({})) {
    if (known->get_name() == name) return *known;
    names.push_back(known->get_name());
  }
  if (const std::string start = file_as_command(name); !start.empty())
    throw Refusal{"raceway: " + start, {.key = name}};
  throw of_command_line("raceway", name + ": no such command" + text::suggestion(name, names),
                        name);
}

int Program::run(int argc, char** argv) {
  const std::string first = argv[1];
  const bool has_command = !first.starts_with('-');
  const CLI::App& of = has_command ? command(first) : app_;
  const std::string name = has_command ? "raceway " + first : "raceway";
  if (const auto problem = flag_problem(of, {argv + (has_command ? 2 : 1), argv + argc}))
    throw of_command_line(name, problem->what, problem->flag);
  try {
    app_.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app_.exit(e);  // help and version
    throw of_command_line(name, e.what() + advice_on(e, std::span(argv, argc).subspan(2)),
                          missing_name(of));
  }
  CLI::App* const given = app_.get_subcommands().front();
  check_files(*given);
  return runs_.at(given)();
}

}  // namespace raceway::cli
