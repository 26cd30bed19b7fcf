#include <algorithm>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/comparison_text.h"
#include "cli/messages.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "session/loop.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct CompareFlags {
  std::vector<std::string> files;  // models, then data
  session::CompareOptions how;
  session::LoopOptions loop;
  bool json = false, force = false;
  ReportFlag report;
};

/// Models come first; data begin with the first name that ends in .csv, else are the last.
std::size_t first_data(const std::vector<std::string>& files) {
  const auto found = std::find_if(files.begin() + 1, files.end() - 1,
                                  [](const std::string& name) { return name.ends_with(".csv"); });
  return static_cast<std::size_t>(found - files.begin());
}

int run(const CompareFlags& flags) {
  if (flags.files.size() < 2)
    throw text::InputError(
        "raceway compare: DATA is missing; name one or more models first and the measurements last",
        {.key = "DATA"});
  const auto data_begin =
      flags.files.begin() + static_cast<std::ptrdiff_t>(first_data(flags.files));
  flags.report.check(on_existing(flags.force));
  const session::ComparedModels compared =
      session::compare(messages(), session::files({flags.files.begin(), data_begin}),
                       session::files({data_begin, flags.files.end()}), flags.how, flags.loop);
  if (flags.json)
    put_document(compared.json());
  else if (compared.models.size() == 1)
    print_comparison(compared.names.front(), compared.models.front().errors, compared.data);
  else
    print_ladders(compared.names, compared.errors());
  flags.report.write([&] { return compared.page(); }, on_existing(flags.force));
  return done;
}

}  // namespace

Run setup_compare(CLI::App& command) {
  auto flags = std::make_shared<CompareFlags>();
  command
      .add_option("FILES", flags->files,
                  "MODEL [MODEL2 ...] DATA [DATA2 ...]: models (TOML), then measurements (CSV)")
      ->type_name("")
      ->expected(-1);
  command
      .add_option("--refit", flags->how.refit,
                  "parameters that the command fits to DATA before the comparison, separated by "
                  "commas, such as f0,z")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command
      .add_option(
          "--zero", flags->how.zero,
          "for corrections, the error of each run that is subtracted before the comparison:\nmean "
          "(mean error of the run; default), first (error of the first reading of the run), none")
      ->check(CLI::IsMember({"mean", "first", "none"}))
      ->type_name("WHICH");
  declare(command, flags->loop);
  declare(command, flags->loop.tolerance);
  declare_json(command, flags->json);
  flags->report.declare(command);
  command.add_flag("--force", flags->force, "replace the page if it exists");
  command.footer(
      "An error is prediction minus reading.\n\n"
      "Example:\n  raceway compare my.toml rig.csv\n"
      "  raceway compare my.toml fitted.toml rig.csv --report page.html\n"
      "  raceway compare my.toml monday.csv friday.csv --per-record f0,z");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
