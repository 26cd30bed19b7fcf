#include "files/detail/column_proposal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "record/series_channel.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/timestamp.h"

namespace raceway::files {
namespace {

using record::Role;

constexpr std::size_t for_a_unit = 20, for_a_date = 10;

bool all_cells(const text::CsvTable& table, std::size_t column, auto&& holds) {
  bool any = false;
  for (std::size_t row = 0; row < std::min<std::size_t>(table.rows(), 20); ++row) {
    const std::string cell = table.shown(row, column);
    if (text::is_missing(cell)) continue;
    if (!holds(cell)) return false;
    any = true;
  }
  return any;
}

text::ParsedNumber number_in(const text::CsvTable& table, std::string_view cell) {
  return text::parse_number(cell, table.separator != ',');
}

/// Times rise, but for the few places where a run begins anew.
bool can_be_times(const std::vector<double>& values) {
  if (values.size() < 2) return true;
  constexpr double nearly_all = 0.8;
  std::size_t up = 0;
  for (std::size_t k = 1; k < values.size(); ++k) up += values[k] > values[k - 1] ? 1 : 0;
  return static_cast<double>(up) >= nearly_all * static_cast<double>(values.size() - 1);
}

/// In C, K or F.
bool can_be_temperatures(const std::vector<double>& values) {
  constexpr double coldest_of_all = -80.0, hottest_of_all = 600.0;
  const auto at = [](std::vector<double> list, double share) {
    const auto place =
        list.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(list.size() - 1));
    std::nth_element(list.begin(), place, list.end());
    return *place;
  };
  // A few readings that are none do not count.
  return values.empty() || (at(values, 0.1) > coldest_of_all && at(values, 0.9) < hottest_of_all);
}

/// t is a time and T a temperature, where a column could be either.
bool has_its_letter(std::string_view name, const record::Channel& channel) {
  return (name == "t" && channel.role == Role::time) ||
         (name == "T" && record::is_temperature(channel));
}

std::string line_of(const text::CsvTable& table, const ColumnProposal& p) {
  const std::string header = text::in_quotes(table.header[p.column]);
  if (p.has_our_name)
    return fmt::format("# {} needs no line, because raceway knows this name", header);
  const text::Unit* const own = unit_of(*p.channel);
  if (p.excel_date)
    return fmt::format("{} = {{ column = {}, unit = \"excel\" }}", p.channel->name, header);
  if (p.stamped || !own) return fmt::format("{} = {}", p.channel->name, header);
  if (!p.unknown_unit.empty())
    return fmt::format(
        "# {} = {{ column = {}, unit = \"...\" }}  # the file has the unknown unit {}: is it {}?",
        p.channel->name, header, text::in_quotes(p.unknown_unit),
        text::listed_units(own->dimension));
  // A unit that stands here counts as said by the user, and is not asked about again.
  if (!p.unit)
    return fmt::format("{} = {}  # no unit in the file; raceway reads it in {}", p.channel->name,
                       header, own->suffix);
  return fmt::format("{} = {{ column = {}, unit = \"{}\" }}", p.channel->name, header,
                     p.unit->suffix);
}

/// "[a, b]" of several, else the one.
std::string one_or_list(const std::vector<std::string>& columns) {
  return columns.size() == 1 ? columns.front() : fmt::format("[{}]", fmt::join(columns, ", "));
}

/// `time_s = ["Zeit", "Timestamp"]` where columns of several files need a rule for one quantity;
/// otherwise empty.
std::string rule_of_several(const std::vector<ProposedFile>& files,
                            const record::Channel& channel) {
  std::size_t count = 0;
  std::vector<std::string> columns;
  for (const ProposedFile& file : files)
    for (const ColumnProposal& p : file.proposals) {
      if (!(*p.channel == channel) || p.has_our_name || !p.unknown_unit.empty()) continue;
      const std::string line = line_of(*file.table, p);
      const std::size_t begin = line.find(" = ") + 3;
      std::string column = line.substr(begin, line.find("  #") - begin);
      ++count;
      if (std::find(columns.begin(), columns.end(), column) == columns.end())
        columns.push_back(std::move(column));
    }
  return count > 1 ? fmt::format("{} = {}\n", channel.name, one_or_list(columns)) : std::string();
}

std::string rule_text(const ColumnRule& rule) {
  if (rule.constant) return fmt::format("{}", *rule.constant);
  std::string text = "{ column = " + text::in_quotes(rule.header);
  if (rule.unit || rule.excel_date)
    text += fmt::format(", unit = \"{}\"", rule.excel_date ? "excel" : rule.unit->suffix);
  if (rule.factor != 1.0) text += fmt::format(", factor = {}", rule.factor);
  return text + " }";
}

/// Lines of the map that the user gave.
std::string rules_text(const ColumnMap& map) {
  std::string text;
  if (map.decimal_mark != '\0') text += fmt::format("decimal_mark = \"{}\"\n", map.decimal_mark);
  if (map.date_order) text += fmt::format("date_order = \"{}\"\n", text::name(*map.date_order));
  if (map.settings_hold)
    text += fmt::format("settings_hold = \"{} row\"\n",
                        *map.settings_hold == record::SettingsHold::from_row ? "from" : "until");
  for (std::size_t first = 0, next = 0; first < map.rules.size(); first = next) {
    const std::string& key = map.rules[first].key;
    std::vector<std::string> columns;
    for (; next < map.rules.size() && map.rules[next].key == key; ++next)
      columns.push_back(rule_text(map.rules[next]));
    text += fmt::format("{} = {}\n", key, one_or_list(columns));
  }
  return text;
}

}  // namespace

std::string plain_name(std::string_view header) {
  std::string result = text::lower_case(text::header_parts(header).name);
  for (char& c : result)
    if (c == ' ' || c == '-' || c == '.' || c == ',') c = '_';
  return result;
}

std::size_t longest_word_in(std::string_view name, std::string_view words) {
  std::size_t longest = 0;
  for (const std::string_view word : text::split(words, ' ')) {
    const std::size_t at = name.find(word);
    if (at == name.npos || word.size() <= longest) continue;
    const bool alone = (at == 0 || name[at - 1] == '_') &&
                       (at + word.size() == name.size() || name[at + word.size()] == '_');
    if (word.size() > 2 || alone) longest = word.size();
  }
  return longest;
}

std::vector<double> numbers_in(const text::CsvTable& table, std::size_t column) {
  std::vector<double> list;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (const text::ParsedNumber n = number_in(table, table.shown(row, column));
        n.problem.empty() && std::isfinite(n.value))
      list.push_back(n.value);
  return list;
}

std::optional<ColumnProposal> column_as(const text::CsvTable& table, std::size_t column,
                                        const record::Channel& channel) {
  const text::HeaderParts parts = text::header_parts(table.header[column]);
  const text::Unit* const own = unit_of(channel);
  const std::string_view below =
      column < table.units.size() ? std::string_view(table.units[column]) : std::string_view();
  const std::string_view written = parts.unit.empty() ? below : parts.unit;
  const bool some_unit = text::find_unit(written) != nullptr;
  ColumnProposal p{.channel = &channel,
                   .column = column,
                   .unit = own ? text::find_unit(written, own->dimension) : nullptr};
  if (own && parts.unit.empty() && !p.unit)
    p.unit = text::unit_at_end(table.header[column], own->dimension);
  if (own && !p.unit && !some_unit) p.unknown_unit = std::string(written);
  // A unit of another kind: "Last [mm]" is no load.
  if (some_unit && !p.unit) return std::nullopt;
  const bool numbers = all_cells(
      table, column, [&](std::string_view cell) { return number_in(table, cell).problem.empty(); });
  if (channel.role == Role::time) {
    p.stamped = all_cells(table, column, text::is_time);
    p.excel_date = !p.unit && all_cells(table, column, [&](std::string_view cell) {
      const double days = number_in(table, cell).value;
      return days > 20000 && days < 80000;
    });
    if (p.stamped || p.excel_date) p.score += for_a_date;
    if (!p.stamped && (!numbers || !can_be_times(numbers_in(table, column)))) return std::nullopt;
  } else if (channel.role != Role::run && !numbers) {
    return std::nullopt;
  }
  if (record::is_temperature(channel) && !can_be_temperatures(numbers_in(table, column)))
    return std::nullopt;
  if (p.unit) p.score += for_a_unit;
  if (has_its_letter(parts.name, channel)) p.score += 1;
  return p;
}

std::string proposed_columns(const std::vector<ProposedFile>& files,
                             const std::vector<std::string>& missing, const ColumnMap& given) {
  std::vector<std::string> names, others;
  for (const ProposedFile& file : files)
    names.push_back(std::filesystem::path(file.table->source).filename().string());
  std::string text = fmt::format(
      "# Columns of {}, proposed from their names and units: check each line.\n"
      "# For --columns FILE, or for the model file.\n"
      "[columns]\n",
      text::listed(names));
  text += rules_text(given);
  std::vector<const record::Channel*> written;
  for (const ProposedFile& file : files) {
    for (const ColumnProposal& p : file.proposals) {
      const std::string line = line_of(*file.table, p);
      if (const std::string rule = rule_of_several(files, *p.channel); rule.empty())
        text += line + (p.remark.empty() ? "\n" : "  # " + p.remark + "\n");
      else if (std::find(written.begin(), written.end(), p.channel) == written.end())
        text += rule;
      written.push_back(p.channel);
    }
    for (std::size_t c = 0; c < file.table->header.size(); ++c)
      if (std::none_of(file.proposals.begin(), file.proposals.end(),
                       [&](const ColumnProposal& p) { return p.column == c; }) &&
          !given.find(file.table->header[c]))
        others.push_back(text::in_quotes(file.table->header[c]));
  }
  for (const std::string& line : missing) text += line + "\n";
  if (!others.empty()) text += "# not used: " + text::listed(others) + "\n";
  return text;
}

}  // namespace raceway::files
