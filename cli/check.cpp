#include <fmt/format.h>

#include "cli/check_text.h"
#include "cli/commands.h"
#include "cli/output_flags.h"
#include "results/record_text.h"
#include "results/results.h"
#include "session/loop.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct CheckFlags : OutputFlags {
  std::string model, data;
  session::LoopOptions loop{.defaults = session::Defaults::keep};
  CsvStyle csv;
  bool json = false, suggest = false;
};

/// A map of the columns of the file, on stdout or in a file.
int suggest(const CheckFlags& flags) {
  if (flags.data.empty())
    throw text::InputError("raceway check: --suggest-columns needs DATA",
                           {.key = "--suggest-columns"});
  flags.require_writable();
  session::LoopOptions options = flags.loop;
  options.defaults = session::Defaults::count;
  flags.put(session::suggested_columns(messages(), flags.model, flags.data, std::move(options)));
  return done;
}

int run_model(const CheckFlags& flags) {
  const session::LoopModel::About model = session::describe(messages(), flags.model, flags.loop);
  if (flags.json)
    put_document(results::model_check_json(model.name, model.defaults, model.notes));
  else
    print_defaults(model.source, model.defaults);
  return done;
}

int run(const CheckFlags& flags) {
  flags.refuse_stdout("check", "what was read");
  flags.csv.require_writable(flags.output, flags.if_exists());
  if (flags.data.empty()) return run_model(flags);
  const session::CheckedModel checked =
      session::check(messages(), flags.model, flags.data, flags.loop);
  if (flags.json) {
    put_document(checked.json());
  } else {
    print_check(checked.check, checked.data);
    fmt::print("\n");
    const record::SettingsHold hold = checked.data.settings_hold;
    if (checked.over_time || hold != record::SettingsHold::sampled) print_settings_hold(hold);
    if (checked.over_time) {
      print_check(*checked.over_time);
      fmt::print("\n");
    }
    print_defaults(checked.model.source, checked.model.defaults);
    if (!checked.over_time && checked.check.problem.empty() && flags.data != "-" &&
        flags.model != "-")
      fmt::print(
          "\nnext step: raceway diagnose {} {}{}\n", flags.model, flags.data,
          flags.loop.reading.columns.empty() ? "" : " --columns " + flags.loop.reading.columns);
  }
  if (!flags.output.empty())
    flags.csv.put(flags.output, results::record_text(checked.data), flags.if_exists(),
                  fmt::format(", {} rows", checked.data.rows()));
  return done;
}

}  // namespace

Run setup_check(CLI::App& command) {
  auto flags = std::make_shared<CheckFlags>();
  declare_model(command, flags->model);
  command
      .add_option("DATA", flags->data,
                  "measurements (CSV); without them, the command checks only the model")
      ->type_name("");
  declare_channel(command, flags->loop.channel);
  declare(command, flags->loop.reading);
  declare_beside(command, flags->loop.reading);
  declare_json(command, flags->json);
  flags->declare_output(
      command,
      "CSV file for the rows as raceway reads them (for a coast-down: the calculated torques); "
      "with --suggest-columns, TOML file for the table [columns]");
  flags->csv.declare(command);
  flags->declare_force(command);
  command
      .add_flag("--suggest-columns", flags->suggest,
                "only propose a map from the columns of the file to the columns of raceway (TOML)")
      ->excludes("--json");
  for (const char* const of_data : {"--columns", "--drop-nan", "--beside", "--output"})
    command.get_option(of_data)->needs("DATA");
  command.footer(
      "Example:\n  raceway check my.toml\n  raceway check my.toml rig.csv\n"
      "  raceway check my.toml export.csv --suggest-columns -o map.toml\n"
      "  raceway check my.toml export.csv --columns map.toml");
  return [flags] {
    show_every_message();
    if (flags->suggest) return suggest(*flags);
    return run(*flags);
  };
}

}  // namespace raceway::cli
