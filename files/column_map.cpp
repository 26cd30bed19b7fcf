#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "files/detail/data_columns.h"
#include "files/detail/signal_channels.h"
#include "record/series_channel.h"
#include "record/spindle_channel.h"
#include "text/input_file.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/column_section.h"
#include "files/detail/transducer_section.h"

namespace raceway::files {
namespace {

using record::Channel;

constexpr Key columns_keys[]{
    {"decimal_mark", one_of(".|,"), unset,
     "decimal mark of the file, point or comma; the other of these two marks separates thousands. "
     "Required if a number can be read in two ways, such as 1,234"},
    {"date_order", one_of("day first|month first|year first"), unset,
     "order of day, month and year in dates with slashes, dashes or two-digit years. Required if "
     "the dates can be read in several orders that give different times between the rows"},
    {"settings_hold", one_of("from row|until row"), unset,
     "period in which the settings (speed, loads, feeds, coolant) of a row apply, for records over "
     "time. \"from row\": from this row to the next row, as in a list of events; the reading of "
     "the row was taken just before the settings changed. \"until row\": from the previous row to "
     "this row, as in loggers whose time is the end of an interval. Default for a spindle: \"until "
     "row\". Default for a correction: the settings apply from this row to the next row, and the "
     "reading of the row was taken with these settings"},
};
constexpr Key rule_keys[]{
    {"column", a_text, is_required,
     "header of the column in your file. Replace COLUMN by the name of the column in raceway, such "
     "as speed_rpm. Short forms: COLUMN = \"header\", or COLUMN = number if all rows have the same "
     "value. If files have different headers: COLUMN = [\"header 1\", \"header 2\"]"},
    {"unit", a_text, "from the header",
     "unit of the column in your file; \"excel\" for Excel serial dates (days)"},
    {"factor", between(-1e9, 1e9), 1.0,
     "factor by which the program multiplies the column before it converts the unit; not 0"},
};

std::string_view variable_of(const Channel& channel) {
  return channel.variable == channel.name ? text::header_parts(channel.name).name
                                          : channel.variable;
}

/// "Axial load" and "axial_load" are one name.
bool same_name(std::string_view given, std::string_view variable) {
  std::string name = text::lower_case(given);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name == variable;
}

Names names_of_channels() {
  Names names;
  for (const Channel* c : file_channels()) names.emplace_back(c->name);
  return names;
}

text::Place place_of(const Section& s, const toml::key& key) {
  return {.file = s.source(),
          .line = static_cast<int>(key.source().begin.line),
          .key = std::string(key.str())};
}

[[noreturn]] void wrong(const Section& s, const toml::key& key, const toml::node& node,
                        const std::string& problem) {
  throw text::InputError(fmt::format("{}: [columns] {} = {}: {}", place_of(s, key).text(),
                                     key.str(), text::shown(node), problem),
                         place_of(s, key));
}

/// `unit = "Nm"` of a rule, or "excel" for dates.
void read_unit(const Section& s, const toml::key& key, const std::string& text, ColumnRule& rule) {
  const text::Unit* const own = unit_of(*rule.channel);
  rule.excel_date = *rule.channel == record::time && text == "excel";
  if (rule.excel_date) return;
  if (own) rule.unit = text::find_unit(text, own->dimension);
  if (rule.unit) return;
  const std::string known = own ? "must be " + text::listed_units(own->dimension)
                                : "this quantity has no unit; remove the unit";
  throw text::InputError(
      fmt::format("{}: [columns] {}: unit = \"{}\": {}{}", place_of(s, key).text(), key.str(), text,
                  known, *rule.channel == record::time ? ", or excel for Excel serial dates" : ""),
      place_of(s, key));
}

/// `{ column = "Reibmoment", unit = "Nm", factor = -1 }`
void read_rule_table(const Section& s, const toml::key& key, const toml::table& table,
                     ColumnRule& rule) {
  const Section one(s.source(), fmt::format("columns.{}", key.str()), &table, {rule_keys});
  const auto column = one.text("column");
  if (!column || column->empty())
    wrong(s, key, table, "the header of the column in your file is missing: column = \"...\"");
  rule.header = *column;
  if (const auto unit = one.text("unit")) read_unit(s, key, *unit, rule);
  rule.factor = one.value("factor");
  if (rule.factor == 0.0) wrong(s, key, table, "factor = 0: must not be 0");
}

ColumnRule read_rule(const Section& s, const toml::key& key, const toml::node& node,
                     const ColumnMap& map) {
  auto named = map.find_transducer(key.str());
  if (!named) named = named_channel(key.str(), file_channels());
  if (!named) named = named_series_channel(key.str());
  if (!named) named = named_spindle_channel(key.str());
  if (!named) {
    const Names known = names_of_channels();
    const std::string near = text::suggestion(key.str(), known);
    wrong(s, key, node,
          "raceway has no column of this name" +
              (near.empty() ? "; it has " + text::listed(known) : near));
  }
  ColumnRule rule{.key = std::string(key.str()),
                  .channel = named->channel,
                  .key_unit = named->unit,
                  .place = place_of(s, key)};
  if (node.is_number()) {
    const double value = *node.value<double>();
    const Channel& c = *rule.channel;
    const double si = rule.key_unit ? rule.key_unit->to_SI(value) : c.to_SI(value);
    if (c.role == record::Role::run || c.role == record::Role::measured)
      wrong(s, key, node,
            "must be a column of the file in quotes; one number for all rows is not possible");
    const double lower = c.is_input() ? -c.upper : c.lower;  // the sign is judged with the model
    if (!(si >= c.to_SI(lower) && si <= c.to_SI(c.upper)))
      wrong(s, key, node, fmt::format("must be from {} to {} {}", c.lower, c.upper, c.unit));
    rule.constant = value;
  } else if (node.is_string() && !node.value<std::string>()->empty()) {
    rule.header = *node.value<std::string>();
  } else if (node.is_table()) {
    read_rule_table(s, key, *node.as_table(), rule);
  } else {
    wrong(
        s, key, node,
        "must be the header of a column in quotes, a list of such headers, a number for all rows, "
        "or { column = \"...\", unit = \"...\" }");
  }
  return rule;
}

/// Rises through a file, also on one line.
std::uint64_t order_of(const toml::key& key) {
  constexpr std::uint64_t most_columns = 100000;
  return std::uint64_t{key.source().begin.line} * most_columns + key.source().begin.column;
}

}  // namespace

std::span<const Channel* const> file_channels() {
  static const auto all = [] {
    constexpr std::array further{&speed_from,
                                 &speed_to,
                                 &fall_time_deviation,
                                 &torque_signal,
                                 &torque_signal_deviation,
                                 &reference_torque,
                                 &calibration_signal};
    std::array<const Channel*, record::channels.size() + further.size()> list{};
    for (std::size_t k = 0; k < record::channels.size(); ++k) list[k] = &record::channels[k];
    std::copy(further.begin(), further.end(), list.begin() + record::channels.size());
    return list;
  }();
  return all;
}

const text::Unit* unit_of(const Channel& channel) {
  const std::string_view unit = text::header_parts(channel.name).unit;
  return unit.empty() ? nullptr : text::find_unit(unit);
}

std::optional<NamedChannel> named_channel(std::string_view name,
                                          std::span<const Channel* const> channels) {
  for (const Channel* c : channels)
    if (c->name == name) return NamedChannel{c};
  const text::HeaderParts parts = text::header_parts(name);
  if (parts.unit.empty()) return std::nullopt;
  for (const Channel* c : channels) {
    const text::Unit* const own = unit_of(*c);
    if (!own || !same_name(parts.name, variable_of(*c))) continue;
    if (const text::Unit* const unit = text::find_unit(parts.unit, own->dimension))
      return NamedChannel{c, unit == own ? nullptr : unit};
  }
  return std::nullopt;
}

std::optional<NamedChannel> named_series_channel(std::string_view name) {
  if (const Channel* const exact = record::series_channel(name)) return NamedChannel{exact};
  static constexpr std::array fixed{&record::time, &record::speed, &record::run};
  if (auto named = named_channel(name, fixed)) return named;
  const text::HeaderParts parts = text::header_parts(name);
  std::string base = text::lower_case(parts.name);
  std::replace(base.begin(), base.end(), ' ', '_');
  for (const std::string_view ending : {"_C", "_m_min", "_rpm", "_um", "_urad", "_mm", "_A", "_V",
                                        "_W", "_N", "_Nm", "_l_min", "_bar", "_percent"}) {
    const Channel* const channel = record::series_channel(base + std::string(ending));
    const text::Unit* const own = channel ? unit_of(*channel) : nullptr;
    const text::Unit* const unit = own ? text::find_unit(parts.unit, own->dimension) : nullptr;
    if (unit) return NamedChannel{channel, unit == own ? nullptr : unit};
  }
  return std::nullopt;
}

std::optional<NamedChannel> named_spindle_channel(std::string_view name) {
  if (const Channel* const exact = record::spindle_channel(name)) return NamedChannel{exact};
  static constexpr std::array fixed{&record::time,
                                    &record::run,
                                    &record::speed,
                                    &record::axial_load,
                                    &record::radial_load,
                                    &record::nose_moment,
                                    &record::belt_force,
                                    &record::motor_heat,
                                    &record::motor_power,
                                    &record::axial_displacement,
                                    &record::displacement_deviation};
  if (auto named = named_channel(name, fixed)) return named;
  const auto of_series = named_series_channel(name);
  const Channel* const channel =
      of_series ? record::spindle_channel(of_series->channel->name) : nullptr;
  return channel ? std::optional(NamedChannel{channel, of_series->unit}) : std::nullopt;
}

const ColumnRule* ColumnMap::find(std::string_view header) const {
  for (const ColumnRule& rule : rules)
    if (!rule.header.empty() && rule.header == header) return &rule;
  return nullptr;
}

std::string ColumnMap::headers_of(const Channel& channel) const {
  std::vector<std::string> headers;
  for (const ColumnRule& rule : rules)
    if (*rule.channel == channel && !rule.constant) headers.push_back(text::in_quotes(rule.header));
  return text::listed(headers, "or");
}

std::vector<KeyTable> column_tables() {
  return {{"columns", columns_keys}, {"columns.COLUMN", rule_keys}};
}

ColumnMap read_columns(const ModelTables& tables) {
  const Section s = tables.part("columns", {columns_keys});
  ColumnMap map{.source = tables.source(), .transducers = read_transducers(tables)};
  if (!s.given()) return map;
  if (const auto mark = s.choice("decimal_mark")) map.decimal_mark = mark->front();
  if (const auto wanted = s.choice("date_order"))
    for (const text::DateOrder order : text::date_orders)
      if (text::name(order) == *wanted) map.date_order = order;
  if (const auto hold = s.choice("settings_hold"))
    map.settings_hold =
        *hold == "from row" ? record::SettingsHold::from_row : record::SettingsHold::until_row;
  const auto is_of_file = [](std::string_view name) {
    return std::any_of(std::begin(columns_keys), std::end(columns_keys),
                       [&](const Key& k) { return k.name == name; });
  };
  // In the order of the file, for messages.
  std::map<std::uint64_t, std::pair<const toml::key*, const toml::node*>> lines;
  for (const auto& [key, node] : *s.table())
    if (!is_of_file(key.str())) lines.emplace(order_of(key), std::pair(&key, &node));
  const auto add = [&](const toml::key& key, const toml::node& node) {
    ColumnRule rule = read_rule(s, key, node, map);
    for (const ColumnRule& other : map.rules) {
      if (*other.channel == *rule.channel && other.key != rule.key)
        throw text::InputError(
            fmt::format("{}: [columns] {} and {} are the same quantity; keep one of them",
                        rule.place.text(), other.key, rule.key),
            rule.place);
      if (!rule.header.empty() && other.header == rule.header)
        throw text::InputError(
            fmt::format("{}: [columns] {} and {} both name the column \"{}\"; correct one of them",
                        rule.place.text(), other.key, rule.key, rule.header),
            rule.place);
    }
    map.rules.push_back(std::move(rule));
  };
  for (const auto& [_, line] : lines) {
    const auto& [key, node] = line;
    const toml::array* const headers = node->as_array();
    if (!headers || headers->empty()) {
      add(*key, *node);
      continue;
    }
    for (const toml::node& one : *headers) {
      if (one.is_number())
        wrong(s, *key, *node, "a list may have only headers in quotes, or { column = \"...\" }");
      add(*key, one);
    }
  }
  return map;
}

ColumnMap parse_column_map(std::string_view text, const std::string& source) {
  const ModelTables tables(text, source);
  for (const auto& [key, node] : tables.root())
    if ((key.str() != "columns" && key.str() != "transducers") || !node.is_table())
      throw text::InputError(
          fmt::format(
              "{}: {}: a file for --columns may have only the tables [columns] and [transducers]",
              tables.place(key), key.str()),
          tables.at(key));
  if (!tables.section("columns").given() && !tables.section("transducers").given())
    throw text::InputError(
        source +
            ": the table [columns] is missing; write speed_rpm = \"header in your file\" and so on",
        {.file = source, .key = "columns"});
  return read_columns(tables);
}

ColumnMap read_column_map(const std::string& path) {
  return parse_column_map(text::read_text(path), path);
}

}  // namespace raceway::files
