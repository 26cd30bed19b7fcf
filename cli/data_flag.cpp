#include "cli/data_flag.h"

#include "io/error.h"

namespace raceway::cli {

void DataFlag::declare(CLI::App& command) {
  command
      .add_option("--columns", columns,
                  "which of their columns is which of ours (TOML, table [columns]);\n"
                  "default: that of the model; check --suggest-columns proposes one")
      ->type_name("FILE");
  command.add_flag("--drop-nan", drop_nan,
                   "leave out rows with an empty cell, nan or #N/A in a column that counts");
}

io::ReadOptions DataFlag::options(const io::ModelFile& model) const {
  if (period.is_given())
    throw io::InputError(
        model.model.spindle
            ? "--from, --until: a spindle is simulated from the first row on, and held against all "
              "of them; cut the file"
            : "--from, --until: belong to records over time, of a model with [correction]",
        {.key = period.from.empty() ? "--until" : "--from"});
  io::ReadOptions result = options(model.columns);
  result.sensor = model.sensor;
  return result;
}

io::ReadOptions DataFlag::options(const io::ColumnMap& of_model) const {
  io::ReadOptions result = options();
  if (columns.empty()) result.columns = of_model;
  return result;
}

io::ReadOptions DataFlag::options() const {
  io::ReadOptions result{.columns = {}, .sensor = {}, .drop_nan = drop_nan};
  if (!columns.empty()) result.columns = io::read_column_map(columns);
  return result;
}

}  // namespace raceway::cli
