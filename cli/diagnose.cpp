#include "verdict/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/commands.h"
#include "cli/diagnosis_text.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/process.h"
#include "cli/progress.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "session/loop.h"

namespace raceway::cli {
namespace {

struct DiagnoseFlags {
  std::string model;
  std::vector<std::string> data;
  session::LoopOptions loop;
  bool json = false, verbose = false, no_pairs = false, force = false;
  int tried_before = 0;
  double time_limit = 120.0;  // [s]
  ReportFlag report;
};

/// No verdict within the time.
struct OutOfTime : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where a column is in another unit, laws are far from where they hold, and solves take long.
std::string out_of_time(const DiagnoseFlags& flags, const record::Record& data) {
  std::string text = fmt::format(
      "raceway diagnose: no verdict within {:.4g} s; allow more time with --time-limit {:.4g}{}",
      flags.time_limit, 10.0 * flags.time_limit, flags.no_pairs ? "" : ", or use --no-pairs");
  const std::span<const double> speeds = data.values(record::speed);
  if (!speeds.empty()) {
    const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
    text += fmt::format(". The speeds are {:.4g} to {:.4g} rpm: is rpm the correct unit?",
                        *low / rpm, *high / rpm);
  }
  return text;
}

verdict::Diagnosis diagnosis_of(const DiagnoseFlags& flags, const session::LoopQuestion& asked) {
  verdict::DiagnoseOptions options;
  options.pairs = !flags.no_pairs;
  require_range(flags.tried_before, {0.0, 1e6, "explanations"}, "--tried-before");
  options.tried_before = flags.tried_before;
  const InterruptFlag interrupt(flags.time_limit);
  options.cancelled = &InterruptFlag::raised();
  std::optional<Progress> bar;
  if (shows_progress()) {
    bar.emplace();
    options.progress = [&bar](double share, std::string_view step) { bar->show(share, step); };
  }
  try {
    return session::diagnose(asked, options);
  } catch (const fit::Cancelled&) {
    if (!interrupt.out_of_time()) throw;
    throw OutOfTime(out_of_time(flags, asked.data));
  }
}

int run(const DiagnoseFlags& flags) {
  if (flags.verbose) show_every_message();
  flags.report.check(on_existing(flags.force));
  const session::LoopQuestion asked =
      session::ask(messages(), flags.model, session::files(flags.data), flags.loop);
  verdict::Diagnosis diagnosis;
  try {
    diagnosis = diagnosis_of(flags, asked);
  } catch (const OutOfTime& e) {
    say(e.what());
    return not_converged;
  }
  tell(diagnosis.messages);
  count_hidden_messages();  // above the verdict
  if (flags.json)
    put_document(session::json(asked, diagnosis));
  else
    print_diagnosis(diagnosis, flags.verbose);
  flags.report.write([&] { return session::page(asked, diagnosis); }, on_existing(flags.force));
  return done;
}

}  // namespace

Run setup_diagnose(CLI::App& command) {
  auto flags = std::make_shared<DiagnoseFlags>();
  declare_model(command, flags->model);
  command.add_option("DATA", flags->data, "measurements (CSV), one or more files")
      ->required()
      ->type_name("")
      ->expected(-1);
  command.add_flag("--no-pairs", flags->no_pairs, "test single effects only, which is faster");
  command
      .add_option("--tried-before", flags->tried_before,
                  "number of explanations that you have already tried on these data; diagnose then "
                  "requires a larger gain")
      ->type_name("N");
  add_number(command, "--time-limit", flags->time_limit, {0.001, 1e6, "s"},
             "time after which diagnose stops [s]; default 120");
  declare(command, flags->loop);
  declare(command, flags->loop.tolerance);
  command.add_flag("--verbose", flags->verbose,
                   "print all details: every effect, intervals, errors of the held-out blocks, "
                   "points to measure, detectable sizes of effects");
  declare_json(command, flags->json);
  flags->report.declare(command);
  command.add_flag("--force", flags->force, "replace the page if it exists");
  command.footer(
      "The program joins several DATA files into one record, and assumes that a missing\neffect is "
      "the same in all of them.\n\nExample:\n  raceway diagnose my.toml rig.csv --report "
      "page.html\n  raceway diagnose my.toml monday.csv friday.csv --per-record f0,z");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
