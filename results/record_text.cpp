#include "results/record_text.h"

#include <fmt/format.h>

#include "text/detail/csv_text.h"

namespace raceway::results {

using record::Role;

std::string record_text(const record::Record& record) {
  fmt::memory_buffer out;
  std::vector<const record::Column*> columns;
  for (const record::Column& column : record.columns)
    if (column.channel->role != Role::part) columns.push_back(&column);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (c > 0) out.push_back(',');
    text::append_text(out, columns[c]->channel->name);
  }
  out.push_back('\n');
  for (std::size_t row = 0; row < record.rows(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) out.push_back(',');
      const record::Channel& channel = *columns[c]->channel;
      if (channel.role == Role::run)
        text::append_text(out, record.runs[static_cast<std::size_t>(record.run_of(row))]);
      else
        text::append_value(out, channel.in_unit(columns[c]->values[row]));
    }
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace raceway::results
