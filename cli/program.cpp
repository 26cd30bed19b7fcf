#include "cli/program.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "cli/messages.h"
#include "cli/parse_problem.h"
#include "cli/run_files.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

struct Command {
  const char* name;
  const char* summary;
  Run (*setup)(CLI::App&);
};

constexpr std::array commands{
    Command{"solve", "Contact angles, loads, stiffness and friction at one operating point",
            setup_solve},
    Command{"table", "Stribeck table: friction torque over speed, loads and temperature",
            setup_table},
    Command{"merge", "Join the slabs of a Stribeck table", setup_merge},
    Command{"displacement", "Shaft position, forces and friction of its bearings against speed",
            setup_displacement},
    Command{"spindle",
            "Temperatures, preload and displacement of a spindle through a speed programme",
            setup_spindle},
    Command{"sensitivity", "Which datum of a model matters most for what it predicts",
            setup_sensitivity},
    Command{"fit-law", "Fit the kinematic displacement law u = A n^(1 - B exp(-C n)) to a curve",
            setup_fit_law},
    Command{"step-response", "How a spindle moves after a step of its speed: K, T and their laws",
            setup_step_response},
    Command{"deflection", "How a shaft gives way on its bearings under a force, bearing by bearing",
            setup_deflection},
    Command{"modes", "Natural frequencies of a shaft on its bearings against speed: Campbell",
            setup_modes},
    Command{"calibrate", "Fit the free parameters of a model to measurements", setup_calibrate},
    Command{"calibrate-sensor", "Fit the curve of a torque sensor to readings with known torques",
            setup_calibrate_sensor},
    Command{"compare", "How wrong a model is against measurements, and where", setup_compare},
    Command{"diagnose", "Which physical effect is missing, or what to measure to find out",
            setup_diagnose},
    Command{"add", "Switch an effect on, calibrated, if it helps on rows the fit did not see",
            setup_add},
    Command{"identify", "Find the lags of a correction from a record over time", setup_identify},
    Command{"correct", "Run a correction over a record: displacement from what a machine knows",
            setup_correct},
    Command{"export", "A correction as something that runs in a control: Python, C, CSV, LinuxCNC",
            setup_export},
    Command{"join", "Make one correction of several that move the same axis", setup_join},
    Command{"effects", "The catalogue of physical effects, or one of them explained",
            setup_effects},
    Command{"keys", "The keys of model files, with unit, default and range", setup_keys},
    Command{"bearings", "The catalogue of bearings", setup_bearings},
    Command{"new", "Write a commented model file of a bearing, a spindle or a correction",
            setup_new},
    Command{"check", "What was read from a model and its data, and what can be learnt from it",
            setup_check},
    Command{"describe", "Completions of bash and zsh and man pages, of the commands as they are",
            setup_describe},
};

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
  app_.footer(
      "Numbers go to stdout, messages to stderr; --json gives one JSON document, of an error\n"
      "too. A file named - is standard input. raceway help COMMAND has its flags.\n"
      "Exit status: 0 done, 1 wrong input, 2 not converged.\n\n"
      "Example:\n"
      "  raceway new \"S 6014 C\" -o my.toml\n"
      "  raceway table my.toml --speed 0:12000:1000 --axial-load 100,300,900");
  for (const Command& c : commands) {
    CLI::App* command = app_.add_subcommand(c.name, c.summary);
    runs_[command] = c.setup(*command);
    command->add_flag_callback(
        "--quiet", [] { set_quiet(true); }, "no notes on stderr; warnings and errors stay");
  }
}

const CLI::App& Program::command(const std::string& name) const {
  std::vector<std::string> names;
  for (const CLI::App* known : app_.get_subcommands({})) {
    if (known->get_name() == name) return *known;
    names.push_back(known->get_name());
  }
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
    throw of_command_line(name, e.what(), missing_name(of));
  }
  CLI::App* const given = app_.get_subcommands().front();
  check_files(*given);
  return runs_.at(given)();
}

}  // namespace raceway::cli
