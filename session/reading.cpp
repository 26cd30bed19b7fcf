#include "session/reading.h"

#include "text/error.h"

namespace raceway::session {

std::vector<Source> Reading::sources(std::vector<Source> data) const {
  if (beside.empty()) return data;
  if (data.size() != 1)
    throw text::InputError(
        "--beside is only possible with one record, but several records are given",
        {.key = "--beside"});
  for (const std::string& path : beside) data.front().beside.emplace_back(path);
  return data;
}

files::ReadOptions Reading::options(const files::ModelFile& model) const {
  if (period.is_given())
    throw text::InputError(
        model.model.spindle
            ? "--from, --until: not possible for a spindle, because its simulation starts at the "
              "first row; shorten the file instead"
            : "--from, --until are only for records over time and models with [correction]",
        {.key = period.from.empty() ? "--until" : "--from"});
  files::ReadOptions result = options(model.columns);
  result.sensor = model.sensor;
  return result;
}

files::ReadOptions Reading::options(const files::ColumnMap& of_model) const {
  files::ReadOptions result = options();
  if (columns.empty() && columns_text.empty()) result.columns = of_model;
  if (result.columns.transducers.empty()) result.columns.transducers = of_model.transducers;
  return result;
}

files::ReadOptions Reading::options() const {
  files::ReadOptions result{.columns = {}, .sensor = {}, .drop_nan = drop_nan};
  result.without_readings = without_readings;
  if (!columns_text.empty())
    result.columns = files::parse_column_map(columns_text, "columns");
  else if (!columns.empty())
    result.columns = files::read_column_map(columns);
  return result;
}

}  // namespace raceway::session
