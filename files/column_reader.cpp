#include "files/detail/column_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "files/detail/impossible_cells.h"
#include "record/median.h"
#include "text/error.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::files {
namespace {

/// Words in the place of readings.
struct Missing {
  static constexpr std::size_t shown = 5;
  std::size_t count = 0;
  std::vector<std::string> texts{};  ///< the first of them
  std::string lines{};

  void add(const text::CsvTable& table, std::size_t row, std::size_t column) {
    if (++count <= shown) lines += fmt::format("{}{}", lines.empty() ? "" : ", ", table.line(row));
    std::string text = table.shown(row, column);
    if (texts.size() < shown && std::find(texts.begin(), texts.end(), text) == texts.end())
      texts.push_back(std::move(text));
  }
};

}  // namespace

std::vector<double> ColumnReader::numbers(
    const ColumnSource& source, bool with_sign,
    const std::function<bool(std::size_t row)>& may_be_empty) {
  std::vector<double> list;
  list.reserve(table_.rows());
  Missing missing;
  ImpossibleCells impossible(table_, source, with_sign);
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    if (may_be_empty(row) && (is_missing(row, source.column) || impossible.has(row))) {
      if (!table_.is_empty(row, source.column)) missing.add(table_, row, source.column);
      list.push_back(unset);
      continue;
    }
    const text::ParsedNumber number = si_of_cell(table_, row, source, with_sign, bad);
    if (number.decimal_mark != '\0')
      keep_mark(number.decimal_mark, row, table_.cell(row, source.column));
    list.push_back(number.value);
  }
  if (missing.count > 0)
    notes_.push_back(record::note::left_out(
        fmt::format(
            "{} of {} readings of {} have no valid value ({}) and are not used (line{} {}{})",
            missing.count, table_.rows(), source.name, text::listed(missing.texts),
            missing.count == 1 ? "" : "s", missing.lines,
            missing.count > Missing::shown ? ", ..." : ""),
        {.file = table_.source, .key = source.name}));
  return list;
}

bool ColumnReader::is_missing(std::size_t row, std::size_t column) const {
  return table_.is_numeric(column) ? table_.is_empty(row, column)
                                   : text::is_missing(table_.cell(row, column));
}

bool ColumnReader::is_stamped(const ColumnSource& source) const {
  return files::is_stamped(table_, source);
}

std::string ColumnReader::stamp(const ColumnSource& source, std::size_t row) const {
  std::string text = table_.shown(row, source.column);
  return source.dates ? table_.shown(row, *source.dates) + " " + text : text;
}

std::vector<double> ColumnReader::times(const ColumnSource& source,
                                        std::optional<text::DateOrder> order) {
  const bool excel = source.excel_date, texts = !excel || !table_.is_numeric(source.column);
  const std::string begin = stamp(source, 0);
  const auto unit = texts && !excel && !source.dates ? unit_of_short_times(source) : std::nullopt;
  // A time of day is one that has passed since midnight.
  const auto parse_passed = [&](std::string_view cell) {
    if (const auto passed = text::parse_elapsed(cell)) return passed;
    if (const auto time = unit ? text::parse_short_time(cell) : std::nullopt)
      return std::optional(*unit * (time->units + time->sixtieths / 60.0));
    return text::parse_clock(cell);
  };
  const bool elapsed = texts && !excel && parse_passed(begin).has_value();
  if (!order) order = texts && !excel && !elapsed ? order_of(source) : text::DateOrder::day_first;
  std::vector<double> list;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    std::optional<double> time;
    if (texts) {
      const std::string cell = stamp(source, row);
      time = elapsed ? parse_passed(cell) : text::parse_timestamp(cell, *order);
    }
    if (!time && excel) {
      const text::ParsedNumber days = table_.parsed(row, source.column);
      if (days.problem.empty()) time = text::seconds_of_excel(days.value);
    }
    if (!time)
      bad.add(table_.line(row), source.name, stamp(source, row),
              elapsed ? "is not a time such as 1:30:05"
                      : "is not a time such as 2024-03-12T08:15:00 or 12.03.2024 08:15:00");
    list.push_back(time.value_or(unset));
  }
  const double first = list.front();
  clock_start_ = {.kind = elapsed ? ClockKind::elapsed : ClockKind::dates, .begin = first};
  if (elapsed) {
    undo_midnights(source, list);
  } else {
    clock_start_->has_zone = !table_.is_numeric(source.column) && text::has_zone(begin);
    clock_start_->changes = undo_changes_of_clocks(source, list);
  }
  for (double& time : list) time -= first;
  if (!std::isnan(first) && !elapsed)
    notes_.push_back(
        record::note::read_as(fmt::format("column {} has {}: time_s is measured from {}",
                                          source.name, source.excel_date ? "Excel dates" : "dates",
                                          undecided_date_ ? begin : text::timestamp_text(first)),
                              {.file = table_.source, .key = source.name}));
  if (unit && elapsed)
    notes_.push_back(record::note::read_as(
        fmt::format("column {} has {}", source.name,
                    *unit > 60.0 ? "hours and minutes" : "minutes and seconds"),
        {.file = table_.source, .key = source.name}));
  if (elapsed && first > 0.0)
    notes_.push_back(record::note::read_as(
        fmt::format("column {} has {}: time_s is measured from {}", source.name,
                    unit || text::parse_elapsed(begin) ? "elapsed times" : "times of day", begin),
        {.file = table_.source, .key = source.name}));
  return list;
}

std::optional<double> ColumnReader::unit_of_short_times(const ColumnSource& source) const {
  constexpr double hour = 3600.0, minute = 60.0;
  const auto short_time = [&](std::size_t row) {
    return text::parse_short_time(table_.shown(row, source.column));
  };
  if (!short_time(0)) return std::nullopt;
  // The user, the header ("Time [h:mm]", "t in min") or the row of units says it.
  const auto said = [&](std::string_view text) {
    const std::string form = text::lower_case(text);
    const text::Unit* const unit =
        text::find_unit(form.substr(0, form.find(':')), text::Dimension::time);
    if (unit && (unit->factor == hour || unit->factor == minute)) return unit->factor;
    return form == "hh:mm" ? hour : form == "mm:ss" || form == "m:ss" ? minute : unset;
  };
  double unit = source.cells.unit ? said(source.cells.unit->suffix) : unset;
  if (std::isnan(unit)) unit = said(text::header_parts(source.name).unit);
  if (std::isnan(unit) && source.column < table_.units.size())
    unit = said(table_.units[source.column]);
  if (!std::isnan(unit)) return unit;
  // A stop watch goes on with hours; a clock begins anew behind 23.
  std::optional<text::ShortTime> before;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const auto time = short_time(row);
    if (!time && text::parse_elapsed(table_.shown(row, source.column))) return minute;
    if (time && before && before->units == 23 && time->units == 0) return hour;
    before = time;
  }
  const text::Place place{table_.source, table_.line(0), source.name};
  throw text::InputError(
      fmt::format("{}: {} = {}: does the column have hours and minutes, or minutes and seconds? "
                  "Set unit = \"h\" or \"min\" in [columns]: {} = {{ column = {}, unit = \"h\" }}",
                  place.text(), source.name, table_.shown(0, source.column), source.channel->name,
                  text::in_quotes(source.name)),
      place);
}

/// Times of day begin anew at midnight.
void ColumnReader::undo_midnights(const ColumnSource& source, std::vector<double>& list) {
  constexpr double day = 86400.0, longest_step = 7200.0;
  if (std::any_of(list.begin(), list.end(), [](double t) { return t >= day; })) return;
  double shift = 0.0, before = list.front();
  std::size_t count = 0, first = 0;
  for (std::size_t row = 1; row < list.size(); ++row) {
    const double now = list[row];
    if (now < before && now + day - before < longest_step) {
      shift += day;
      if (count++ == 0) first = row;
    }
    before = now;
    list[row] += shift;
  }
  if (count > 0)
    notes_.push_back(record::note::read_as(
        fmt::format("the times in column {} pass midnight {}, first before line {}: time_s "
                    "continues without a jump",
                    source.name, count == 1 ? "once" : fmt::format("{} times", count),
                    table_.line(first)),
        {.file = table_.source, .line = table_.line(first), .key = source.name}));
}

text::DateOrder ColumnReader::order_of(const ColumnSource& source) {
  const std::string begin = stamp(source, 0);
  const std::size_t mark = std::min(begin.find_first_of("/-."), begin.size());
  if (mark != 1 && mark != 2) return text::DateOrder::day_first;
  std::vector<Reading> readings;
  for (const text::DateOrder order : text::date_orders) {
    if (order == text::DateOrder::month_first && begin[mark] == '.') continue;  // as day first
    if (Reading reading{order, elapsed_in(source, order)}; !reading.elapsed.empty())
      readings.push_back(std::move(reading));
  }
  // A record has no gap of a year, as dates have that are read from the wrong end.
  const auto jumps = [](const Reading& r) { return r.jumps(); };
  if (!std::all_of(readings.begin(), readings.end(), jumps)) std::erase_if(readings, jumps);
  if (readings.empty()) return text::DateOrder::day_first;
  for (std::size_t row = 0; row < table_.rows(); ++row)
    for (const Reading& other : readings)
      if (other.elapsed[row] != readings.front().elapsed[row]) ask_for_order(source, readings, row);
  // All readings give the same elapsed times, so the order does not matter.
  undecided_date_ = readings.size() > 1 && begin[mark] != '.';
  return readings.front().order;
}

/// Since the first row; empty where some cell has no such date.
std::vector<double> ColumnReader::elapsed_in(const ColumnSource& source,
                                             text::DateOrder order) const {
  std::vector<double> list;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const auto time = text::parse_timestamp(stamp(source, row), order);
    if (!time) return {};
    list.push_back(*time);
  }
  const double first = list.front();
  for (double& time : list) time -= first;
  return list;
}

void ColumnReader::ask_for_order(const ColumnSource& source, const std::vector<Reading>& readings,
                                 std::size_t row) const {
  const std::string cell = stamp(source, row);
  std::vector<std::string> dates, orders;
  for (const Reading& r : readings) {
    dates.push_back(text::timestamp_text(*text::parse_timestamp(cell, r.order)).substr(0, 10));
    orders.push_back(fmt::format("\"{}\"", text::name(r.order)));
  }
  const text::Place place{table_.source, table_.line(row), source.name};
  throw text::InputError(
      fmt::format("{}: {} = {}: is it {}? Set date_order = {} in [columns]", place.text(),
                  source.name, cell, text::listed(dates, "or"), text::listed(orders, "or")),
      place);
}

bool ColumnReader::Reading::jumps() const {
  constexpr double nearly_a_year = 300.0 * 86400.0;
  for (std::size_t row = 1; row < elapsed.size(); ++row)
    if (const double step = elapsed[row] - elapsed[row - 1];
        step < -nearly_a_year || step > nearly_a_year)
      return true;
  return false;
}

/// A clock of local time goes back an hour, or leaves one out, in the night of a change.
std::vector<ColumnReader::ClockChange> ColumnReader::undo_changes_of_clocks(
    const ColumnSource& source, std::vector<double>& list) {
  std::vector<ClockChange> changes;
  std::vector<double> steps;
  for (std::size_t row = 1; row < list.size(); ++row)
    if (list[row] > list[row - 1]) steps.push_back(list[row] - list[row - 1]);
  if (steps.empty()) return changes;
  constexpr double hour = 3600.0, short_gap = 1200.0;
  const double usual = record::median(steps);
  // Rows need not be even, and some may be missing there.
  const double longest = std::max(1.5 * usual, std::min(20.0 * usual, short_gap));
  double shift = 0.0, before = list.front();
  for (std::size_t row = 1; row < list.size(); ++row) {
    const double now = list[row], step = now - before;
    const auto may_have_passed = [&](double time) { return time > 0.0 && time <= longest; };
    // One that goes forward leaves a whole hour out, from one full hour to the next.
    const double left_out = hour * std::ceil(before / hour);
    constexpr double rounding = 1e-3;
    const bool back = step <= 0.0 && may_have_passed(step + hour),
               forward = now > left_out + hour - rounding && may_have_passed(step - hour);
    if ((back || forward) && text::clocks_may_change(before, forward) &&
        (table_.is_numeric(source.column) || !text::has_zone(stamp(source, row)))) {
      shift += back ? hour : -hour;
      changes.push_back({before, table_.line(row), forward});
      notes_.push_back(record::note::read_as(
          fmt::format("line {}: the clock goes {} by one hour, at {} of summer time: time_s "
                      "continues without a jump",
                      table_.line(row), back ? "back" : "forward",
                      back ? "the end" : "the beginning"),
          {.file = table_.source, .line = table_.line(row), .key = source.name}));
    }
    before = now;
    list[row] += shift;
  }
  return changes;
}

std::vector<double> ColumnReader::named(const ColumnSource& source,
                                        std::vector<std::string>& names) {
  std::unordered_map<std::string, std::size_t> index;
  std::vector<double> list;
  list.reserve(table_.rows());
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const std::string text = table_.shown(row, source.column);
    if (text.empty()) bad.add(table_.line(row), source.channel->name, text, "is empty");
    const auto [entry, is_new] = index.emplace(text, names.size());
    if (is_new) names.emplace_back(text);
    list.push_back(static_cast<double>(entry->second));
  }
  return list;
}

void ColumnReader::keep_mark(char mark, std::size_t row, std::string_view text) {
  Mark& first = mark == ',' ? comma_ : point_;
  if (first.line == 0) first = {table_.line(row), std::string(text)};
}

void ColumnReader::check_decimal_marks() const {
  if (comma_.line == 0 || point_.line == 0) return;
  throw text::InputError(
      fmt::format("{}:{}: {} has a decimal comma, but {} in line {} has a decimal point; use the "
                  "same decimal mark in the whole file",
                  table_.source, comma_.line, comma_.cell, point_.cell, point_.line),
      {.file = table_.source, .line = comma_.line});
}

std::vector<record::Note> ColumnReader::notes_on_form() const {
  std::vector<std::string> form;
  if (table_.separator == ';') form.emplace_back("semicolons");
  if (table_.separator == '\t') form.emplace_back("tabs");
  if (comma_.line != 0) form.emplace_back("decimal commas");
  if (table_.byte_order_mark) form.emplace_back("a byte order mark");
  if (table_.carriage_returns) form.emplace_back("CRLF line ends");
  const record::Place place{.file = table_.source};
  std::vector<record::Note> notes = notes_of(record::note::read_as, table_.notes, place);
  if (!form.empty())
    notes.push_back(record::note::read_as("read with " + text::listed(form), place));
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  return notes;
}

}  // namespace raceway::files
