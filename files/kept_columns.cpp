#include "files/detail/kept_columns.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "record/kept_channel.h"
#include "text/error.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::files {
namespace {

/// Nothing where a cell is a text, or a number that can be read in two ways.
std::optional<std::vector<double>> numbers_of(const text::CsvTable& table, std::size_t column) {
  std::vector<double> values;
  values.reserve(table.rows());
  bool any = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!table.is_numeric(column) && text::is_missing(table.cell(row, column))) {
      values.push_back(unset);
      continue;
    }
    try {
      const text::ParsedNumber number = table.parsed(row, column);
      if (!number.problem.empty() && !table.is_numeric(column)) return std::nullopt;
      any = any || std::isfinite(number.value);
      values.push_back(number.value);
    } catch (const text::InputError&) {
      return std::nullopt;  // only who uses it is asked
    }
  }
  return any ? std::optional(std::move(values)) : std::nullopt;
}

std::string_view unit_in(const text::CsvTable& table, std::size_t column) {
  const std::string_view header = table.header[column];
  if (const std::string_view stated = text::in_brackets(header); !text::states_no_unit(stated))
    return stated;
  if (column < table.units.size() && !text::states_no_unit(table.units[column]))
    return table.units[column];
  return text::header_parts(header).unit;
}

}  // namespace

KeptColumns kept_columns(const text::CsvTable& table, const std::vector<std::string>& headers) {
  KeptColumns kept;
  for (const std::string& header : headers) {
    const std::size_t column = *table.column(header);
    if (auto values = numbers_of(table, column))
      kept.columns.push_back(
          {&record::kept_channel(header, unit_in(table, column)), *std::move(values)});
    else
      kept.texts.push_back(header);
  }
  return kept;
}

std::vector<std::string> KeptColumns::statements(bool named_by_user) const {
  std::vector<std::string> names;
  for (const record::Column& c : columns) {
    const std::string_view unit = c.channel->unit;
    const bool shown = unit.empty() || c.channel->name.find(unit) != std::string_view::npos;
    names.push_back(shown ? std::string(c.channel->name)
                          : fmt::format("{} [{}]", c.channel->name, unit));
  }
  std::vector<std::string> list;
  if (!names.empty())
    list.push_back(fmt::format("columns kept, but not used by the model: {}", text::listed(names)));
  if (!texts.empty())
    list.push_back(
        named_by_user ? "not used: " + text::listed(texts)
                      : fmt::format("column{} {} unknown and ignored", texts.size() == 1 ? "" : "s",
                                    text::listed(texts) + (texts.size() == 1 ? " is" : " are")));
  return list;
}

}  // namespace raceway::files
