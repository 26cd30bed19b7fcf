#include "cli/shared_flags.h"

namespace raceway::cli {

void declare_model(CLI::App& command, std::string& model, const std::string& with) {
  command.add_option("MODEL", model, "model file (TOML)" + (with.empty() ? "" : " with " + with))
      ->required()
      ->type_name("");
}

void declare_json(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "one JSON document instead of text");
}

void declare_coolant(CLI::App& command, bool& on, const std::string& help) {
  command
      .add_option_function<std::string>(
          "--coolant", [&on](const std::string& state) { on = state == "on"; }, help)
      ->check(CLI::IsMember({"on", "off"}))
      ->type_name("STATE");
}

void declare(CLI::App& command, session::Reading& reading) {
  command
      .add_option(
          "--columns", reading.columns,
          "map from your columns to the columns of raceway (TOML, table [columns]); "
          "default: [columns] of the model, if it has one; check --suggest-columns proposes a map")
      ->type_name("FILE");
  command.add_flag("--drop-nan", reading.drop_nan,
                   "ignore rows with an empty cell, nan or #N/A in a column that is used");
}

void declare_beside(CLI::App& command, session::Reading& reading) {
  command
      .add_option("--beside", reading.beside,
                  "for a record over time: another file of the same record with its own time "
                  "column, such as temperatures of another logger; repeat the flag for each file")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("FILE");
}

void declare(CLI::App& command, session::Period& period) {
  command
      .add_option("--from", period.from,
                  "for models with [correction]: use only readings from this time on, such as 22h; "
                  "the model still uses the inputs of all rows")
      ->type_name("TIME");
  command
      .add_option("--until", period.until,
                  "for models with [correction]: use only readings up to this time")
      ->type_name("TIME");
}

void declare_channel(CLI::App& command, std::string& channel) {
  command
      .add_option("--channel,--displacement", channel,
                  "for a MODEL with several quantities, such as two [[correction]]: the predicted "
                  "column to use, such as displacement_z_um")
      ->type_name("COLUMN");
}

void declare(CLI::App& command, session::LoopOptions& loop) {
  declare_channel(command, loop.channel);
  command
      .add_option("--per-record", loop.per_record,
                  "for several DATA: parameters that are fitted to each record separately, "
                  "separated by commas, such as f0,z; all other parameters are common")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command.add_flag("--rows", loop.rows,
                   "use all rows of a logger; default: consecutive rows at equal speed and load "
                   "are averaged to dwells");
  declare(command, loop.reading);
  declare_beside(command, loop.reading);
  declare(command, loop.reading.period);
}

void declare(CLI::App& command, session::Tolerance& tolerance) {
  command
      .add_option("--tolerance", tolerance.text,
                  "largest RMS error that you accept, such as 2Nmm or 2um,0.5K; for models without "
                  "this tolerance under [loop] or [correction]")
      ->type_name("VALUES");
}

}  // namespace raceway::cli
