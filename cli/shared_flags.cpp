#include "cli/shared_flags.h"

#include "text/error.h"

namespace raceway::cli {

void refuse_two_on_stdout(const std::string& command, bool json, const std::string& output) {
  if (json && output == "-")
    throw text::InputError(
        "raceway " + command + ": --json and --output - both write to stdout; take one",
        {.key = "--output"});
}

void declare(CLI::App& command, session::Reading& reading) {
  command
      .add_option("--columns", reading.columns,
                  "map of your columns to ours (TOML, table [columns]); default: [columns] of\n"
                  "the model; check --suggest-columns proposes one")
      ->type_name("FILE");
  command.add_flag("--drop-nan", reading.drop_nan,
                   "leave out rows with an empty cell, nan or #N/A in a column that counts");
}

void declare_beside(CLI::App& command, session::Reading& reading) {
  command
      .add_option("--beside", reading.beside,
                  "of a record over time: a further file of it with a clock of its own,\n"
                  "as temperatures of another logger; again for each")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("FILE");
}

void declare(CLI::App& command, session::Period& period) {
  command
      .add_option("--from", period.from,
                  "of a record over time: only readings from then on count, as 22h;\n"
                  "all rows drive the model")
      ->type_name("TIME");
  command.add_option("--until", period.until, "the same: only readings up to then")
      ->type_name("TIME");
}

void declare_channel(CLI::App& command, std::string& channel) {
  command
      .add_option("--channel,--displacement", channel,
                  "of a MODEL that describes several things, such as two [[correction]]:\n"
                  "a column that the wanted one predicts, as displacement_z_um")
      ->type_name("COLUMN");
}

void declare(CLI::App& command, session::LoopOptions& loop) {
  declare_channel(command, loop.channel);
  command
      .add_option("--per-record", loop.per_record,
                  "of several DATA: fitted to each by itself, such as f0,z (by comma), as\n"
                  "the oil and the temperature of a day; all else is one for all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command.add_flag("--rows", loop.rows,
                   "rows of a logger stay apart; otherwise consecutive rows at equal speed\n"
                   "and load are averaged to dwells");
  declare(command, loop.reading);
  declare_beside(command, loop.reading);
  declare(command, loop.reading.period);
}

void declare(CLI::App& command, session::Tolerance& tolerance) {
  command
      .add_option("--tolerance", tolerance.text,
                  "error below which nothing matters, e.g. 2Nmm or 2um,0.5K;\n"
                  "for models without a tolerance under [loop]")
      ->type_name("VALUES");
}

}  // namespace raceway::cli
