#include "record/record.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raceway::record {

const Column* Record::find(const Channel& channel) const {
  for (const Column& c : columns)
    if (*c.channel == channel) return &c;
  return nullptr;
}

Column* Record::find(const Channel& channel) {
  for (Column& c : columns)
    if (*c.channel == channel) return &c;
  return nullptr;
}

std::span<const double> Record::values(const Channel& channel) const {
  const Column* const column = find(channel);
  return column ? std::span<const double>(column->values) : std::span<const double>();
}

double Record::value(const Channel& channel, std::size_t row) const {
  const Column* const column = find(channel);
  return column ? column->values[row] : unset;
}

int Record::run_of(std::size_t row) const {
  const double index = value(run, row);
  return std::isnan(index) ? -1 : static_cast<int>(index);
}

std::size_t Record::part_of(std::size_t row) const {
  const double index = value(part, row);
  return std::isnan(index) ? 0 : static_cast<std::size_t>(index);
}

Column& Record::set(const Channel& channel, std::vector<double> values) {
  Column* const known = find(channel);
  const bool only = columns.empty() || (known && columns.size() == 1);
  if (!only && values.size() != rows())
    throw std::invalid_argument(std::string(channel.name) + ": a column with " +
                                std::to_string(values.size()) + " values in a record of " +
                                std::to_string(rows()) + " rows");
  if (known) {
    known->values = std::move(values);
    return *known;
  }
  return columns.emplace_back(Column{&channel, std::move(values)});
}

bool Record::varies(const Channel& channel) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values(channel)) {
    if (std::isnan(v)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  const double width = channel.ratio ? std::max(std::abs(low), std::abs(high)) : 1.0;
  return high - low > channel.step * width;
}

const Column* Record::deviation_of(const Channel& measured) const {
  for (const Column& c : columns)
    if (c.channel->role == Role::deviation && c.channel->of == measured.name) return &c;
  return nullptr;
}

bool Record::complete(const Channel& channel) const {
  const std::span<const double> all = values(channel);
  return !all.empty() &&
         std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v); });
}

Record Record::picked(std::span<const std::size_t> wanted) const {
  Record result = without_rows();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    result.columns[c].values.reserve(wanted.size());
    for (const std::size_t i : wanted) result.columns[c].values.push_back(columns[c].values[i]);
  }
  if (!lines.empty())
    for (const std::size_t i : wanted) result.lines.push_back(lines[i]);
  return result;
}

Record Record::without_rows() const {
  Record result{.source = source,
                .columns = {},
                .runs = runs,
                .lines = {},
                .notes = notes,
                .up_to_a_factor = up_to_a_factor,
                .settings_hold = settings_hold,
                .parts = parts};
  for (const Column& c : columns) result.columns.push_back({c.channel, {}, c.known});
  return result;
}

std::string Record::place(std::size_t row) const {
  return (lines.empty() ? "row " : "line ") + std::to_string(line(row)) +
         (parts.empty() ? "" : " of " + parts[part_of(row)].name);
}

int Record::line(std::size_t row) const {
  return lines.empty() ? static_cast<int>(row) + 1 : lines[row];
}

}  // namespace raceway::record
