#include "io/column_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "io/error.h"
#include "io/missing_cell.h"
#include "io/names.h"
#include "io/timestamp.h"

namespace raceway::io {
namespace {

/// Words in the place of readings.
struct Missing {
  static constexpr std::size_t shown = 5;
  std::size_t count = 0;
  std::vector<std::string> texts{};  ///< the first of them
  std::string lines{};

  void add(const CsvTable& table, std::size_t row, std::size_t column) {
    if (++count <= shown) lines += fmt::format("{}{}", lines.empty() ? "" : ", ", table.line(row));
    std::string text(table.cell(row, column));
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
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    if (is_missing(row, source.column) && may_be_empty(row)) {
      if (!table_.is_empty(row, source.column)) missing.add(table_, row, source.column);
      list.push_back(unset);
      continue;
    }
    const ParsedNumber number = si_of_cell(table_, row, source, with_sign, bad);
    if (number.decimal_mark != '\0')
      keep_mark(number.decimal_mark, row, table_.cell(row, source.column));
    list.push_back(number.value);
  }
  if (missing.count > 0)
    notes_.push_back(
        fmt::format("{} of {} readings of {} are no numbers ({}) and do not take part "
                    "(line{} {}{})",
                    missing.count, table_.rows(), source.name, listed(missing.texts),
                    missing.count == 1 ? "" : "s", missing.lines,
                    missing.count > Missing::shown ? ", ..." : ""));
  return list;
}

bool ColumnReader::is_missing(std::size_t row, std::size_t column) const {
  return table_.is_numeric(column) ? table_.is_empty(row, column)
                                   : io::is_missing(table_.cell(row, column));
}

bool ColumnReader::is_stamped(const ColumnSource& source) const {
  return *source.channel == record::time &&
         (source.excel_date || (!table_.is_numeric(source.column) &&
                                parse_timestamp(table_.cell(0, source.column)).has_value()));
}

std::vector<double> ColumnReader::times(const ColumnSource& source) {
  std::vector<double> list;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    std::optional<double> time;
    if (!table_.is_numeric(source.column)) time = parse_timestamp(table_.cell(row, source.column));
    if (!time && source.excel_date) {
      const ParsedNumber days = table_.parsed(row, source.column);
      if (days.problem.empty()) time = seconds_of_excel(days.value);
    }
    if (!time)
      bad.add(table_.line(row), source.name, table_.shown(row, source.column),
              "is no time such as 2024-03-12T08:15:00 or 12.03.2024 08:15:00");
    list.push_back(time.value_or(unset));
  }
  const double first = list.front();
  for (double& time : list) time -= first;
  if (!std::isnan(first))
    notes_.push_back(fmt::format("column {} has {}: time_s counts from {}", source.name,
                                 source.excel_date ? "dates of Excel" : "dates",
                                 timestamp_text(first)));
  return list;
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
  throw InputError(
      fmt::format(
          "{}:{}: {} has a decimal comma, but {} in line {} a decimal point; use one of them",
          table_.source, comma_.line, comma_.cell, point_.cell, point_.line),
      {.file = table_.source, .line = comma_.line});
}

std::vector<std::string> ColumnReader::notes_on_form() const {
  std::vector<std::string> form;
  if (table_.separator == ';') form.emplace_back("semicolons");
  if (table_.separator == '\t') form.emplace_back("tabs");
  if (comma_.line != 0) form.emplace_back("decimal commas");
  if (table_.byte_order_mark) form.emplace_back("a byte order mark");
  if (table_.carriage_returns) form.emplace_back("CRLF line ends");
  std::vector<std::string> notes = table_.notes;
  if (!form.empty()) notes.push_back("read with " + listed(form));
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  return notes;
}

}  // namespace raceway::io
