#include "session/reading.h"

#include "io/error.h"

namespace raceway::session {

io::ReadOptions Reading::options(const io::ModelFile& model) const {
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

io::ReadOptions Reading::options(const io::ColumnMap& of_model) const {
  io::ReadOptions result = options();
  if (columns.empty() && columns_text.empty()) result.columns = of_model;
  return result;
}

io::ReadOptions Reading::options() const {
  io::ReadOptions result{.columns = {}, .sensor = {}, .drop_nan = drop_nan};
  if (!columns_text.empty())
    result.columns = io::parse_column_map(columns_text, "columns");
  else if (!columns.empty())
    result.columns = io::read_column_map(columns);
  return result;
}

}  // namespace raceway::session
