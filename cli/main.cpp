#include <fmt/core.h>

#include <array>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "cli/commands.h"
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
    Command{"calibrate", "Fit the free parameters of a model to measurements",
            cli::setup_calibrate},
    Command{"compare", "How wrong a model is against measurements, and where", cli::setup_compare},
    Command{"bearings", "The catalogue of bearings", cli::setup_bearings},
    Command{"new", "Write a commented model file of a catalogue bearing", cli::setup_new},
    Command{"check", "What was read from a model and its data, and what can be learnt from it",
            cli::setup_check},
};

std::string unknown_command(int argc, char** argv) {
  std::vector<std::string> names;
  for (const Command& c : commands) names.emplace_back(c.name);
  if (argc < 2 || argv[1][0] == '-') return {};
  for (const std::string& name : names)
    if (name == argv[1]) return {};
  return fmt::format("raceway: {}: no such command{}\nTry raceway --help.\n", argv[1],
                     io::suggestion(argv[1], names));
}

}  // namespace

int main(int argc, char** argv) {
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
  if (const std::string message = unknown_command(argc, argv); !message.empty()) {
    fmt::print(stderr, "{}", message);
    return cli::wrong_input;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? cli::done : cli::wrong_input;
  }
  try {
    const int status = runs.at(app.get_subcommands().front())();
    // A full disk or a closed pipe shows up when the last of stdout leaves.
    if (std::fflush(stdout) != 0) {
      fmt::print(stderr, "raceway: stdout could not be written\n");
      return cli::wrong_input;
    }
    return status;
  } catch (const io::InputError& e) {
    fmt::print(stderr, "{}\n", e.what());
  } catch (const std::invalid_argument& e) {
    fmt::print(stderr, "raceway: {}\n", e.what());
  } catch (const std::exception& e) {
    fmt::print(stderr, "raceway: {}\n", e.what());
  }
  return cli::wrong_input;
}
