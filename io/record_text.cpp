#include "io/record_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/csv_text.h"

namespace raceway::io {
namespace {

using record::Role;

/// A name of a run; quoted where it would not stay in its cell.
std::string cell_of(const std::string& name) {
  const auto special = [](char c) { return c == ',' || c == '"' || c == '#' || c == ';'; };
  if (std::none_of(name.begin(), name.end(), special)) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

}  // namespace

std::string record_text(const record::Record& record) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  std::vector<const record::Column*> columns;
  for (const record::Column& column : record.columns)
    if (column.channel->role != Role::part) columns.push_back(&column);
  for (std::size_t c = 0; c < columns.size(); ++c)
    fmt::format_to(put, "{}{}", c == 0 ? "" : ",", columns[c]->channel->name);
  out.push_back('\n');
  for (std::size_t row = 0; row < record.rows(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) out.push_back(',');
      const record::Channel& channel = *columns[c]->channel;
      if (channel.role == Role::run)
        fmt::format_to(put, "{}",
                       cell_of(record.runs[static_cast<std::size_t>(record.run_of(row))]));
      else
        append_value(out, channel.in_unit(columns[c]->values[row]));
    }
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace raceway::io
