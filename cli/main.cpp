#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/messages.h"
#include "cli/process.h"
#include "cli/program.h"
#include "results/results.h"
#include "text/error.h"

namespace {

using namespace raceway;

/// The exit status, once the last of stdout has left.
int finished(int status) {
  cli::count_hidden_messages();
  const std::string problem = cli::stdout_problem();
  if (problem.empty()) return status;
  cli::complain("raceway: " + problem);
  return cli::wrong_input;
}

/// On stderr, and with --json as a document on stdout too; gives the exit status.
int refuse(const cli::Refusal& refusal, bool json) {
  if (json) std::fputs(results::error_json(refusal.message, refusal.place).c_str(), stdout);
  cli::complain(refusal.message);
  return cli::wrong_input;
}

/// `raceway help`, `raceway help solve`.
int help(const cli::Program& program, std::span<char*> names) {
  if (names.empty()) {
    fmt::print("{}", program.help());
    return cli::done;
  }
  for (const char* name : names) fmt::print("{}", program.command(name).help("raceway"));
  return cli::done;
}

int run(int argc, char** argv) {
  cli::Program program;
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
  const bool json = wants_json({argv, argv + argc});
  const auto refused = [json](const cli::Refusal& refusal) {
    return finished(refuse(refusal, json));
  };
  try {
    return finished(run(argc, argv));
  } catch (const cli::Refusal& refusal) {
    return refused(refusal);
  } catch (const text::InputError& e) {
    return refused({e.what(), e.place});
  } catch (const std::system_error& e) {
    if (std::ferror(stdout) == 0) return refused({fmt::format("raceway: {}", e.what())});
    cli::complain("raceway: " + cli::stdout_problem(e.code().value()));
  } catch (const std::bad_alloc&) {
    return refused(
        {"raceway: not enough memory: use fewer points, rows or cells, or several runs"});
  } catch (const std::exception& e) {
    return refused({fmt::format("raceway: {}", e.what())});
  }
  return cli::wrong_input;
}
