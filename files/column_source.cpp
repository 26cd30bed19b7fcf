#include "files/detail/column_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "record/series_channel.h"
#include "record/spindle_channel.h"
#include "text/csv_form.h"
#include "text/error.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/timestamp.h"
#include "text/units.h"

namespace raceway::files {
namespace {

using record::Channel;

/// The unit that a file states for a column of a channel. Throws InputError where it is not known,
/// or measures something else.
const text::Unit& stated_unit(std::string_view text, const Channel& channel,
                              const text::CsvTable& table, std::size_t column) {
  const text::Unit& own = *unit_of(channel);
  if (const text::Unit* const unit = text::find_unit(text, own.dimension)) return *unit;
  const std::string& header = table.header[column];
  throw text::InputError(
      fmt::format("{}: column {}: {} is not a known unit of {}; known units: {}. Give the unit in "
                  "[columns]: {} = {{ column = {}, unit = \"...\" }}",
                  table.header_place().text(), text::in_quotes(header),
                  text::in_quotes(std::string(text)), channel.words,
                  text::listed_units(own.dimension), channel.name, text::in_quotes(header)),
      table.header_place(header));
}

/// The unit in the row of units, null where it states none.
const text::Unit* in_unit_row(const text::CsvTable& table, std::size_t column,
                              const Channel& channel) {
  if (column >= table.units.size() || text::states_no_unit(table.units[column])) return nullptr;
  return &stated_unit(table.units[column], channel, table, column);
}

/// The unit of this kind in a header, in brackets or behind "in", "/", a blank or "_"; null where
/// there is none.
const text::Unit* known_in_header(std::string_view header, const Channel& channel) {
  const text::Dimension own = unit_of(channel)->dimension;
  if (const std::string_view stated = text::in_brackets(header); !text::states_no_unit(stated))
    return text::find_unit(stated, own);
  const std::string_view ending = text::header_parts(header).unit;
  const text::Unit* const unit = ending.empty() ? nullptr : text::find_unit(ending, own);
  return unit ? unit : text::unit_at_end(header, own);
}

/// The unit in a header; in brackets it must be known.
const text::Unit* in_header(const text::CsvTable& table, std::size_t column,
                            const Channel& channel) {
  const std::string_view header = table.header[column];
  if (const std::string_view stated = text::in_brackets(header); !text::states_no_unit(stated))
    return &stated_unit(stated, channel, table, column);
  return known_in_header(header, channel);
}

/// Notes that a rule gives another unit than the header or the row of units.
void note_contradiction(const ColumnRule& rule, const text::CsvTable& table, std::size_t column,
                        Recognised& result) {
  if (!rule.unit || !unit_of(*rule.channel)) return;
  const std::string& header = table.header[column];
  const text::Unit* named = known_in_header(header, *rule.channel);
  if (!named && column < table.units.size())
    named = text::find_unit(table.units[column], unit_of(*rule.channel)->dimension);
  if (named && named != rule.unit)
    result.notes.push_back(record::note::unit(
        fmt::format("column {}: the file gives the unit {}, but {} gives {}, which is used",
                    text::in_quotes(header), named->words, rule.place.text(), rule.unit->words),
        {.key = header}));
}

/// Brackets behind a column of dates hold their form: "Time (UTC)", "Zeit [TT.MM.JJJJ]".
bool has_dates(const text::CsvTable& table, std::size_t column) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (!table.is_empty(row, column))
      return !table.is_numeric(column) && text::is_time(table.cell(row, column));
  return false;
}

/// Of a column that a rule names: what the rule says, else the header, else the row of units, else
/// the key.
const text::Unit* unit_by_rule(const ColumnRule& rule, const text::CsvTable& table,
                               std::size_t column) {
  const Channel& channel = *rule.channel;
  if (rule.unit || rule.excel_date || !unit_of(channel)) return rule.unit;
  if (channel == record::time && has_dates(table, column)) return nullptr;
  if (const text::Unit* const unit = in_header(table, column, channel)) return unit;
  if (const text::Unit* const unit = in_unit_row(table, column, channel)) return unit;
  return rule.key_unit;
}

/// True if the user said in which unit this column is.
bool states_unit(const ColumnRule& rule, const text::CsvTable& table, std::size_t column) {
  return rule.unit || rule.excel_date || rule.factor != 1.0 ||
         (rule.key_unit && unit_by_rule(rule, table, column) == rule.key_unit);
}

/// Of a column that is named as ours: its ending, which a row of units must not contradict.
const text::Unit* unit_by_name(const NamedChannel& named, const text::CsvTable& table,
                               std::size_t column) {
  const text::Unit* const own = unit_of(*named.channel);
  const text::Unit* const ending = named.unit ? named.unit : own;
  const text::Unit* const below = own ? in_unit_row(table, column, *named.channel) : nullptr;
  if (below && below != ending)
    throw text::InputError(
        fmt::format("{}: column {}: its name and the row of units ({}) give different units; "
                    "correct one of them",
                    table.header_place().text(), table.header[column], below->words),
        table.header_place(table.header[column]));
  return named.unit;
}

void note_unit(const ColumnSource& source, Recognised& result) {
  const text::Unit* const own = unit_of(*source.channel);
  if (source.excel_date || !own) return;
  std::string text;
  if (source.cells.unit && source.cells.unit != own)
    text = fmt::format("converted from {}: {}", source.cells.unit->words,
                       text::conversion(*source.cells.unit, *own));
  if (source.cells.factor != 1.0)
    text += fmt::format("{}multiplied by {:.10g}", text.empty() ? "" : ", ", source.cells.factor);
  if (!text.empty())
    result.notes.push_back(record::note::read_as(
        fmt::format("column {} is {}, {}", source.name, source.channel->name, text),
        {.key = source.name}));
}

void add(ColumnSource source, const text::CsvTable& table, Recognised& result) {
  if (const ColumnSource* const twin = result.find(*source.channel))
    throw text::InputError(
        fmt::format("{}: columns {} and {} are both read as {}; keep one of them",
                    table.header_place().text(), twin->name, source.name, source.channel->words),
        table.header_place(source.name));
  result.columns.push_back(std::move(source));
}

bool is_ruled(const ColumnMap& map, const Channel& channel) {
  return std::any_of(map.rules.begin(), map.rules.end(),
                     [&](const ColumnRule& r) { return *r.channel == channel && !r.constant; });
}

std::string_view unit_words(const ColumnSource& source) {
  return source.cells.unit ? source.cells.unit->words : source.channel->unit;
}

std::optional<NamedChannel> named_column(std::string_view name, const ReadOptions& options) {
  if (options.of_spindle) return named_spindle_channel(name);
  if (!options.over_time) return named_channel(name, file_channels());
  const auto transducer = options.columns.find_transducer(name);
  return transducer ? transducer : named_series_channel(name);
}

/// A power, a load or the like of any name: without that unit it may be anything.
bool is_known_by_its_unit(const Channel& channel) {
  return channel.role == record::Role::recorded && !record::is_temperature(channel);
}

/// The channel of a name that ends in a unit in brackets which is not known: "axial load [lbz]".
const Channel* channel_without_unit(std::string_view header, const ReadOptions& options) {
  if (text::states_no_unit(text::in_brackets(header))) return nullptr;
  const std::string_view name = text::header_parts(header).name;
  for (const text::Unit& unit : text::units())
    if (const auto named = named_column(fmt::format("{} [{}]", name, unit.suffix), options);
        named && !is_known_by_its_unit(*named->channel))
      return named->channel;
  return nullptr;
}

text::FormFinder finder(const ReadOptions& options) {
  return [&](std::string_view text) {
    return text::find_form(text, [&](std::string_view cell) {
      return options.columns.find(cell) != nullptr || named_column(cell, options).has_value();
    });
  };
}

bool names_dates(std::string_view header) {
  const std::string name = text::lower_case(header);
  return name.find("date") != name.npos || name.find("datum") != name.npos || name == "day" ||
         name == "tag";
}

/// A date and a time of day in two columns are one time. Either may be the one that is named.
void join_dates(const text::CsvTable& table, Recognised& result) {
  const auto found = std::find_if(result.columns.begin(), result.columns.end(),
                                  [](const auto& c) { return *c.channel == record::time; });
  if (found == result.columns.end() || found->excel_date) return;
  const auto first_is = [&](std::size_t column, const auto& parse) {
    return !table.is_numeric(column) && parse(table.cell(0, column)).has_value();
  };
  const auto date = [](std::string_view cell) {
    std::optional<double> time;
    for (const text::DateOrder order : text::date_orders)
      if (!time) time = text::parse_date(cell, order);
    return time;
  };
  const bool names_clock = first_is(found->column, text::parse_clock);
  if (!names_clock && !first_is(found->column, date)) return;
  for (std::size_t k = 0; k < result.others.size(); ++k) {
    const std::size_t other = *table.column(result.others[k]);
    if (names_clock ? !names_dates(result.others[k]) || !first_is(other, date)
                    : !first_is(other, text::parse_clock))
      continue;
    result.notes.push_back(
        record::note::read_as(fmt::format("columns {} and {} are read together as {}", found->name,
                                          result.others[k], found->channel->name),
                              {.key = found->name}));
    found->dates = names_clock ? other : found->column;
    if (!names_clock) found->column = other;
    result.others.erase(result.others.begin() + static_cast<std::ptrdiff_t>(k));
    return;
  }
}

/// A file that has our own name in the place of theirs needs no rule.
void require_columns(const text::CsvTable& table, const ReadOptions& options, Recognised& found) {
  for (const ColumnRule& rule : options.columns.rules) {
    if (rule.constant) continue;
    if (const ColumnSource* const own = found.find(*rule.channel)) {
      if (!options.columns.find(own->name) && (rule.unit || rule.factor != 1.0))
        found.notes.push_back(record::note::read_as(
            fmt::format("column {} is read directly, because its name is a column name of raceway: "
                        "the rule in {} is not used, and the file has no column \"{}\"",
                        own->name, rule.place.text(), rule.header),
            rule.place));
      continue;
    }
    if (options.of_several || may_be_missing(rule, options)) {
      found.not_here.push_back(&rule);
      continue;
    }
    throw text::InputError(
        fmt::format("{}: the column {} is missing; {} uses it for {}{}; the header has {}",
                    table.header_place().text(), options.columns.headers_of(*rule.channel),
                    rule.place.text(), rule.key, text::suggestion(rule.header, table.header),
                    text::listed(table.header)),
        table.header_place(rule.header));
  }
}

}  // namespace

bool may_be_missing(const ColumnRule& rule, const ReadOptions& options) {
  return options.without_readings && rule.channel->role == record::Role::measured;
}

text::CellRange range_of(const ColumnSource& source, bool with_sign) {
  const Channel& c = *source.channel;
  text::CellRange range{source.name, with_sign ? -c.upper : c.lower, c.upper, unit_words(source)};
  if (source.cells.unit || source.cells.factor != 1.0) {
    range.lower = source.cells.in_cell(c, c.to_SI(range.lower));
    range.upper = source.cells.in_cell(c, c.to_SI(range.upper));
    if (range.lower > range.upper) std::swap(range.lower, range.upper);
  }
  return range;
}

const ColumnSource* Recognised::find(const Channel& channel) const {
  for (const ColumnSource& source : columns)
    if (*source.channel == channel) return &source;
  return nullptr;
}

Recognised recognise(const text::CsvTable& table, const ReadOptions& options) {
  const ColumnMap& map = options.columns;
  const bool of_spindle = options.of_spindle;
  Recognised result;
  const auto has_column_of = [&](const ColumnRule& rule) {
    return table.column(rule.header).has_value();
  };
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    const std::string& name = table.header[c];
    if (const ColumnRule* const rule = map.find(name)) {
      // In a record of a spindle a temperature that another one takes for an input is measured.
      const Channel* const measured =
          of_spindle ? record::spindle_channel(rule->channel->name) : nullptr;
      add({measured ? measured : rule->channel,
           c,
           name,
           {unit_by_rule(*rule, table, c), rule->factor},
           rule->excel_date,
           states_unit(*rule, table, c),
           {}},
          table, result);
      note_contradiction(*rule, table, c, result);
      continue;
    }
    const auto named = named_column(name, options);
    const bool replaced = named && is_ruled(map, *named->channel) &&
                          std::any_of(map.rules.begin(), map.rules.end(), [&](const auto& rule) {
                            return *rule.channel == *named->channel && has_column_of(rule);
                          });
    if (named && !replaced)
      add({named->channel, c, name, {unit_by_name(*named, table, c)}}, table, result);
    else
      result.others.push_back(name);
  }
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    const std::string& name = table.header[c];
    if (map.find(name) || named_column(name, options)) continue;
    const Channel* const meant = channel_without_unit(name, options);
    if (meant && !result.find(*meant)) (void)stated_unit(text::in_brackets(name), *meant, table, c);
  }
  require_columns(table, options, result);
  join_dates(table, result);
  for (const ColumnSource& source : result.columns) note_unit(source, result);
  for (const ColumnRule& rule : map.rules)
    if (rule.constant && !result.find(*rule.channel))
      result.constants.push_back({rule.channel,
                                  rule.key_unit ? rule.key_unit->to_SI(*rule.constant)
                                                : rule.channel->to_SI(*rule.constant),
                                  "[columns] of " + map.source});
  const auto order = [](const Channel* channel) {
    const auto all = file_channels();
    return std::find_if(all.begin(), all.end(), [&](const Channel* c) { return *c == *channel; }) -
           all.begin();
  };
  std::stable_sort(result.columns.begin(), result.columns.end(), [&](const auto& a, const auto& b) {
    return order(a.channel) < order(b.channel);
  });
  return result;
}

bool is_stamped(const text::CsvTable& table, const ColumnSource& source) {
  if (*source.channel != record::time) return false;
  if (source.excel_date || source.dates) return true;
  const std::string first = table.shown(0, source.column);
  const bool is_number = first.find_first_not_of("0123456789") == first.npos;
  return text::is_time(first) && !(is_number && source.unit_stated);
}

text::ParsedNumber si_of_cell(const text::CsvTable& table, std::size_t row,
                              const ColumnSource& source, bool with_sign, text::BadCells& bad) {
  text::ParsedNumber number =
      text::read_cell(table, row, source.column, range_of(source, with_sign), bad);
  number.value = source.cells.to_SI(*source.channel, number.value);
  return number;
}

text::CsvTable read_measurements(const Source& source, const ReadOptions& options) {
  if (source.table) return *source.table;
  text::CsvTable table = source.text
                             ? text::parse_csv(*source.text, source.name, false, finder(options))
                             : text::read_csv(source.name, finder(options));
  if (options.columns.decimal_mark != '\0') table.set_decimal_mark(options.columns.decimal_mark);
  return table;
}

std::string drop_rows(text::CsvTable& table, const std::function<bool(std::size_t row)>& is_wrong,
                      std::string_view have) {
  std::vector<bool> remove(table.rows());
  std::string lines;
  std::size_t count = 0;
  constexpr std::size_t shown = 5;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    remove[row] = is_wrong(row);
    if (!remove[row] || ++count > shown) continue;
    lines += fmt::format("{}{}", lines.empty() ? "" : ", ", table.line(row));
  }
  if (count == 0) return {};
  const std::size_t all = table.rows();
  if (count == all)
    throw text::InputError(
        fmt::format("{}: all {} rows {}, so no row can be used", table.source, all, have),
        {.file = table.source});
  table.remove_rows(remove);
  return fmt::format("{} of {} rows {} and are not used (line{} {}{})", count, all, have,
                     count == 1 ? "" : "s", lines, count > shown ? ", ..." : "");
}

std::string drop_empty_rows(text::CsvTable& table, const std::vector<ColumnSource>& columns) {
  return drop_rows(
      table,
      [&](std::size_t row) {
        return std::any_of(columns.begin(), columns.end(), [&](const ColumnSource& source) {
          return table.is_numeric(source.column) ? !table.parsed(row, source.column).problem.empty()
                                                 : text::is_missing(table.cell(row, source.column));
        });
      },
      "have an empty cell or a cell without a number");
}

std::string if_named_otherwise(const text::CsvTable& table) {
  return fmt::format(
      "If the columns have other names, raceway check MODEL {} --suggest-columns proposes a table "
      "[columns]: copy it into the model file",
      table.source);
}

}  // namespace raceway::files
