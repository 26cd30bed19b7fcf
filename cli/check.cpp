#include <fmt/format.h>

#include "cli/check_text.h"
#include "cli/commands.h"
#include "cli/csv_style.h"
#include "cli/messages.h"
#include "cli/shared_flags.h"
#include "results/record_text.h"
#include "results/results.h"
#include "session/loop.h"
#include "text/error.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct CheckFlags {
  std::string model, data, output;
  session::LoopOptions loop{.defaults = session::Defaults::keep};
  CsvStyle csv;
  bool json = false, suggest = false, force = false;
};

/// A map of the columns of the file, on stdout or in a file.
int suggest(const CheckFlags& flags) {
  if (flags.data.empty())
    throw text::InputError("raceway check: --suggest-columns needs DATA, whose columns it proposes",
                           {.key = "--suggest-columns"});
  const bool to_file = !flags.output.empty() && flags.output != "-";
  const auto if_exists = on_existing(flags.force);
  if (to_file) text::require_writable(flags.output, if_exists);
  session::LoopOptions options = flags.loop;
  options.defaults = session::Defaults::count;
  const std::string map =
      session::suggested_columns(messages(), flags.model, flags.data, std::move(options));
  if (!to_file) {
    fmt::print("{}", map);
    return done;
  }
  text::write_text(flags.output, map, if_exists);
  say(flags.output + " written");
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
  const auto if_exists = on_existing(flags.force);
  if (flags.output == "-")
    throw text::InputError("raceway check: --output -: stdout shows what was read; name a file",
                           {.key = "--output"});
  flags.csv.require_writable(flags.output, if_exists);
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
  }
  if (!flags.output.empty())
    flags.csv.put(flags.output, results::record_text(checked.data), if_exists,
                  fmt::format(", {} rows", checked.data.rows()));
  return done;
}

}  // namespace

Run setup_check(CLI::App& command) {
  auto flags = std::make_shared<CheckFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  command.add_option("DATA", flags->data, "measurements (CSV); without them the model alone")
      ->type_name("");
  declare_channel(command, flags->loop.channel);
  declare(command, flags->loop.reading);
  declare_beside(command, flags->loop.reading);
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command
      .add_option("-o,--output", flags->output,
                  "the rows as they were read, in our columns (CSV), of a coast-down its\n"
                  "torques; with --suggest-columns the table [columns]")
      ->type_name("FILE");
  flags->csv.declare(command);
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command
      .add_flag("--suggest-columns", flags->suggest,
                "only propose which of their columns is which of ours (TOML)")
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
