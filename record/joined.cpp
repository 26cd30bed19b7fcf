#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "record/record.h"

namespace raceway::record {
namespace {

std::vector<Part> parts_of(const std::vector<Record>& records) {
  std::vector<Part> parts;
  for (const Record& r : records)
    parts.push_back({std::filesystem::path(r.source).stem().string(), r.source});
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (parts[i].source == parts[j].source)
        throw std::invalid_argument(parts[i].source + ": is given twice");
      if (std::filesystem::path(parts[j].source).stem() ==
          std::filesystem::path(parts[i].source).stem())
        for (Part* const p : {&parts[i], &parts[j]})
          p->name = std::filesystem::path(p->source).replace_extension().string();
    }
  return parts;
}

/// A column of the joined record for each channel that any of them has.
std::vector<Column> empty_columns(const std::vector<Record>& records) {
  std::vector<Column> columns;
  for (const Record& r : records)
    for (const Column& c : r.columns) {
      const auto same = [&](const Column& known) { return *known.channel == *c.channel; };
      if (std::none_of(columns.begin(), columns.end(), same))
        columns.push_back({c.channel, {}, true});
    }
  for (Column& column : columns)
    column.known = std::all_of(records.begin(), records.end(), [&](const Record& r) {
      const Column* const own = r.find(*column.channel);
      return own && own->known;
    });
  return columns;
}

}  // namespace

Record joined(std::vector<Record> records) {
  if (records.size() < 2)
    throw std::invalid_argument("at least two records are needed to join them");
  for (const Record& r : records)
    if (r.up_to_a_factor)
      throw std::invalid_argument(
          r.source +
          ": its readings have an unknown common factor (inertia_kgm2 = \"unknown\"), so "
          "they cannot be compared with another record");
  for (const Record& r : records)
    if (r.settings_hold != records.front().settings_hold)
      throw std::invalid_argument(r.source +
                                  ": in this record, settings_hold differs from settings_hold of " +
                                  records.front().source);
  std::sort(records.begin(), records.end(),
            [](const Record& a, const Record& b) { return a.source < b.source; });
  Record result;
  result.settings_hold = records.front().settings_hold;
  result.parts = parts_of(records);
  result.columns = empty_columns(records);
  const bool by_line =
      std::none_of(records.begin(), records.end(), [](const Record& r) { return r.lines.empty(); });
  std::vector<double> part_of_row;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const Record& r = records[k];
    result.notes.insert(result.notes.end(), r.notes.begin(), r.notes.end());
    result.source += (k == 0 ? "" : ", ") + r.source;
    const auto runs_before = static_cast<double>(result.runs.size());
    for (Column& column : result.columns) {
      const Column* const own = r.find(*column.channel);
      for (std::size_t i = 0; i < r.rows(); ++i) {
        double value = own ? own->values[i] : unset;
        if (column.channel->role == Role::run) value += runs_before;
        column.values.push_back(value);
      }
    }
    for (const std::string& name : r.runs)
      result.runs.push_back(name + " of " + result.parts[k].name);
    part_of_row.insert(part_of_row.end(), r.rows(), static_cast<double>(k));
    if (by_line) result.lines.insert(result.lines.end(), r.lines.begin(), r.lines.end());
  }
  result.set(part, std::move(part_of_row));
  return result;
}

}  // namespace raceway::record
