#include <fmt/core.h>
#include <glog/logging.h>

#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.h"
#include "cli/parse_problem.h"
#include "cli/process.h"
#include "cli/run_files.h"
#include "io/error.h"
#include "io/names.h"

namespace {

using namespace raceway;

struct Command {
  const char* name;
  const char* summary;
  cli::Run (*setup)(CLI::App&);
};

constexpr std::array commands{
    Command{"solve", "Contact angles, loads, stiffness and friction at one operating point",
            cli::setup_solve},
    Command{"table", "Stribeck table: friction torque over speed, loads and temperature",
            cli::setup_table},
    Command{"merge", "Join the slabs of a Stribeck table", cli::setup_merge},
    Command{"displacement", "Shaft position, forces and friction of its bearings against speed",
            cli::setup_displacement},
    Command{"fit-law", "Fit the kinematic displacement law u = A n^(1 - B exp(-C n)) to a curve",
            cli::setup_fit_law},
    Command{"calibrate", "Fit the free parameters of a model to measurements",
            cli::setup_calibrate},
    Command{"compare", "How wrong a model is against measurements, and where", cli::setup_compare},
    Command{"diagnose", "Which physical effect is missing, or what to measure to find out",
            cli::setup_diagnose},
    Command{"add", "Switch an effect on, calibrated, if it helps on rows the fit did not see",
            cli::setup_add},
    Command{"effects", "The catalogue of physical effects, or one of them explained",
            cli::setup_effects},
    Command{"bearings", "The catalogue of bearings", cli::setup_bearings},
    Command{"new", "Write a commented model file of a catalogue bearing", cli::setup_new},
    Command{"check", "What was read from a model and its data, and what can be learnt from it",
            cli::setup_check},
};

/// Tells on stderr what is wrong with the command line; gives the exit status.
int refuse(const std::string& command, const std::string& problem) {
  cli::write_message(fmt::format("{0}: {1}\nTry {0} --help.\n", command, problem));
  return cli::wrong_input;
}

/// The exit status, once the last of stdout has left.
int finished(int status) {
  const std::string problem = cli::stdout_problem();
  if (problem.empty()) return status;
  cli::write_message("raceway: " + problem + "\n");
  return cli::wrong_input;
}

}  // namespace

int main(int argc, char** argv) {
  cli::start_process();
  // Ceres logs trial points without balance as errors; statuses and messages say it where it
  // counts.
  FLAGS_minloglevel = google::GLOG_FATAL;
  CLI::App app{
      "Friction and kinematics of spindle bearings: compute, and hold against measurements."};
  app.name("raceway");
  app.set_version_flag("--version", "raceway " RACEWAY_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Numbers go to stdout, messages to stderr; --json gives one JSON document.\n"
      "Exit status: 0 done, 1 wrong input, 2 not converged.\n\n"
      "Example:\n"
      "  raceway new \"S 6014 C\" -o my.toml\n"
      "  raceway table my.toml --speed 0:12000:1000 --axial-load 100,300,900");
  std::map<CLI::App*, cli::Run> runs;
  for (const Command& c : commands) {
    CLI::App* command = app.add_subcommand(c.name, c.summary);
    runs[command] = c.setup(*command);
  }
  if (argc < 2) {
    cli::write_message(app.help());
    return cli::wrong_input;
  }
  const std::string first = argv[1];
  if (first == "help") {
    fmt::print("{}", app.help());
    return finished(cli::done);
  }
  const CLI::App* command = first.starts_with('-') ? &app : nullptr;
  std::vector<std::string> names;
  for (const CLI::App* known : app.get_subcommands({})) {
    names.push_back(known->get_name());
    if (names.back() == first) command = known;
  }
  if (command == nullptr)
    return refuse("raceway", first + ": no such command" + io::suggestion(first, names));
  const std::string command_name = command == &app ? "raceway" : "raceway " + first;
  const std::span<char*> arguments(argv + (command == &app ? 1 : 2), argv + argc);
  if (const std::string problem = cli::flag_problem(*command, arguments); !problem.empty())
    return refuse(command_name, problem);
  try {
    app.parse(argc, argv);
    CLI::App* const given = app.get_subcommands().front();
    cli::check_files(*given);
    return finished(runs.at(given)());
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return finished(app.exit(e));  // help and version
    return refuse(command_name, e.what());
  } catch (const io::InputError& e) {
    cli::write_message(fmt::format("{}\n", e.what()));
  } catch (const std::system_error& e) {
    cli::write_message(fmt::format("raceway: {}\n", std::ferror(stdout) != 0
                                                        ? cli::stdout_problem(e.code().value())
                                                        : e.what()));
  } catch (const std::exception& e) {
    cli::write_message(fmt::format("raceway: {}\n", e.what()));
  }
  return cli::wrong_input;
}
