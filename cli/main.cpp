#include <fmt/core.h>
#include <glog/logging.h>

#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/parse_problem.h"
#include "cli/process.h"
#include "cli/run_files.h"
#include "io/error.h"
#include "io/names.h"
#include "io/results.h"

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
    Command{"spindle",
            "Temperatures, preload and displacement of a spindle through a speed programme",
            cli::setup_spindle},
    Command{"sensitivity", "Which datum of a model matters most for what it predicts",
            cli::setup_sensitivity},
    Command{"fit-law", "Fit the kinematic displacement law u = A n^(1 - B exp(-C n)) to a curve",
            cli::setup_fit_law},
    Command{"step-response", "How a spindle moves after a step of its speed: K, T and their laws",
            cli::setup_step_response},
    Command{"deflection", "How a shaft gives way on its bearings under a force, bearing by bearing",
            cli::setup_deflection},
    Command{"modes", "Natural frequencies of a shaft on its bearings against speed: Campbell",
            cli::setup_modes},
    Command{"calibrate", "Fit the free parameters of a model to measurements",
            cli::setup_calibrate},
    Command{"calibrate-sensor", "Fit the curve of a torque sensor to readings with known torques",
            cli::setup_calibrate_sensor},
    Command{"compare", "How wrong a model is against measurements, and where", cli::setup_compare},
    Command{"diagnose", "Which physical effect is missing, or what to measure to find out",
            cli::setup_diagnose},
    Command{"add", "Switch an effect on, calibrated, if it helps on rows the fit did not see",
            cli::setup_add},
    Command{"identify", "Find the lags of a correction from a record over time",
            cli::setup_identify},
    Command{"correct", "Run a correction over a record: displacement from what a machine knows",
            cli::setup_correct},
    Command{"export", "A correction as something that runs in a control: Python, C, CSV, LinuxCNC",
            cli::setup_export},
    Command{"effects", "The catalogue of physical effects, or one of them explained",
            cli::setup_effects},
    Command{"keys", "The keys of model files, with unit, default and range", cli::setup_keys},
    Command{"bearings", "The catalogue of bearings", cli::setup_bearings},
    Command{"new", "Write a commented model file of a catalogue bearing", cli::setup_new},
    Command{"check", "What was read from a model and its data, and what can be learnt from it",
            cli::setup_check},
    Command{"describe", "Completions of bash and zsh and man pages, of the commands as they are",
            cli::setup_describe},
};

/// What ends a run before it has an answer.
struct Refusal {
  std::string message;
  io::Place place = {};
};

/// The exit status, once the last of stdout has left.
int finished(int status) {
  const std::string problem = cli::stdout_problem();
  if (problem.empty()) return status;
  cli::complain("raceway: " + problem);
  return cli::wrong_input;
}

/// On stderr, and with --json as a document on stdout too; gives the exit status.
int refuse(const Refusal& refusal, bool json) {
  if (json) std::fputs(io::error_json(refusal.message, refusal.place).c_str(), stdout);
  cli::complain(refusal.message);
  return cli::wrong_input;
}

/// With the way to the help of that command.
Refusal of_command_line(const std::string& command, const std::string& problem,
                        const std::string& key) {
  return {fmt::format("{0}: {1}\nTry {0} --help.", command, problem), {.key = key}};
}

/// The commands with their flags, and what runs them.
class Program {
 public:
  Program() {
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
          "--quiet", [] { cli::set_quiet(true); }, "no notes on stderr; warnings and errors stay");
    }
  }

  [[nodiscard]] std::string help() const { return app_.help(); }

  /// The command of that name; throws Refusal where there is none.
  [[nodiscard]] const CLI::App& command(const std::string& name) const {
    std::vector<std::string> names;
    for (const CLI::App* known : app_.get_subcommands({})) {
      if (known->get_name() == name) return *known;
      names.push_back(known->get_name());
    }
    throw of_command_line("raceway", name + ": no such command" + io::suggestion(name, names),
                          name);
  }

  /// Throws Refusal, io::InputError and what the libraries throw.
  int run(int argc, char** argv) {
    const std::string first = argv[1];
    const bool has_command = !first.starts_with('-');
    const CLI::App& of = has_command ? command(first) : app_;
    const std::string name = has_command ? "raceway " + first : "raceway";
    if (const auto problem = cli::flag_problem(of, {argv + (has_command ? 2 : 1), argv + argc}))
      throw of_command_line(name, problem->what, problem->flag);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
      if (e.get_exit_code() == 0) return app_.exit(e);  // help and version
      throw of_command_line(name, e.what(), cli::missing_name(of));
    }
    CLI::App* const given = app_.get_subcommands().front();
    cli::check_files(*given);
    return runs_.at(given)();
  }

 private:
  CLI::App app_{
      "Friction and kinematics of spindle bearings: compute, and hold against measurements."};
  std::map<CLI::App*, cli::Run> runs_;
};

/// `raceway help`, `raceway help solve`.
int help(const Program& program, std::span<char*> names) {
  if (names.empty()) {
    fmt::print("{}", program.help());
    return cli::done;
  }
  for (const char* name : names) fmt::print("{}", program.command(name).help("raceway"));
  return cli::done;
}

int run(int argc, char** argv) {
  Program program;
  if (argc < 2) {
    const std::string all = program.help();
    cli::complain(all.substr(0, all.find_last_not_of('\n') + 1));
    return cli::wrong_input;
  }
  const std::span<char*> arguments(argv + 1, argv + argc);
  if (arguments.front() == std::string_view("help")) return help(program, arguments.subspan(1));
  const int status = program.run(argc, argv);
  fmt::print("{}", cli::take_document());
  return status;
}

/// Whether errors are to be told as JSON, also where the flags cannot be understood.
bool wants_json(std::span<char*> arguments) {
  for (const std::string_view argument : arguments) {
    if (argument == "--") return false;
    if (argument == "--json") return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  cli::start_process();
  // Ceres logs trial points without balance as errors; statuses and messages say it where it
  // counts.
  FLAGS_minloglevel = google::GLOG_FATAL;
  const bool json = wants_json({argv, argv + argc});
  const auto refused = [json](const Refusal& refusal) { return finished(refuse(refusal, json)); };
  try {
    return finished(run(argc, argv));
  } catch (const Refusal& refusal) {
    return refused(refusal);
  } catch (const io::InputError& e) {
    return refused({e.what(), e.place});
  } catch (const std::system_error& e) {
    if (std::ferror(stdout) == 0) return refused({fmt::format("raceway: {}", e.what())});
    cli::complain("raceway: " + cli::stdout_problem(e.code().value()));
  } catch (const std::exception& e) {
    return refused({fmt::format("raceway: {}", e.what())});
  }
  return cli::wrong_input;
}
