#include "text/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "text/detail/csv_parser.h"
#include "text/detail/decimal_marks.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/printable.h"
#include "text/text_encoding.h"
#include "text/units.h"

namespace raceway::text {
namespace {

/// Signs and separators as texts have them and programs do not.
bool is_typeset(std::string_view number) {
  return std::any_of(number.begin(), number.end(),
                     [](char c) { return c == '\'' || c == ' ' || (c & 0x80) != 0; });
}

/// With "-" for U+2212, the sign at the number ("- 5"), and no apostrophes or blanks that do not
/// break between groups of three digits (1'200.5).
std::string without_typesetting(std::string_view number) {
  std::string text(number);
  for (const auto& [typeset, plain] : {std::pair<std::string_view, std::string_view>{"\u2212", "-"},
                                       {"\u2019", "'"},
                                       {"\u00a0", "'"},
                                       {"\u2009", "'"},
                                       {"\u202f", "'"}})
    for (std::size_t at = text.find(typeset); at != text.npos; at = text.find(typeset))
      text.replace(at, typeset.size(), plain);
  if (text.starts_with('-') || text.starts_with('+'))
    text.erase(1, text.find_first_not_of(' ', 1) - 1);
  if (is_grouped(text, '\'', '.') || is_grouped(text, '\'', ',')) std::erase(text, '\'');
  return text;
}

}  // namespace

std::string quoted(std::string_view cell) {
  constexpr std::size_t longest = 40;
  if (cell.size() <= longest) return fmt::format("\"{}\"", printable(cell));
  std::size_t cut = longest;
  while (cut > 0 && (static_cast<unsigned char>(cell[cut]) & 0xc0) == 0x80) --cut;
  return fmt::format("\"{}...\"", printable(cell.substr(0, cut)));
}

ParsedNumber parse_number(std::string_view cell, bool decimal_comma) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return {none, '\0', "is empty"};
  const auto points = std::count(cell.begin(), cell.end(), '.');
  const auto commas = std::count(cell.begin(), cell.end(), ',');
  std::string_view digits = cell;
  if (digits.front() == '+') digits.remove_prefix(1);
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  const auto may_start = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == ','; };
  // from_chars would take "nan", "inf" and, after '+', another sign.
  if (digits.size() <= first || (digits.size() < cell.size() && first == 1) ||
      !may_start(digits[first])) {
    std::string word(digits.substr(first));
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (word == "nan" || word == "inf" || word == "infinity")
      return {none, '\0', "is not a finite number"};
    return {none, '\0', "is not a number"};
  }
  const bool only_digits_and_marks = digits.find_first_not_of("0123456789.,-+eE") == digits.npos;
  if (only_digits_and_marks && points + commas > 1)
    return {none, '\0',
            "is ambiguous: write one decimal mark and no thousands separators, as in 1234.5"};
  if (commas > 0 && !decimal_comma && only_digits_and_marks)
    return {none, '\0',
            "has a decimal comma, which is allowed only in files with semicolons or tabs between "
            "the columns"};
  char mark = points > 0 ? '.' : commas > 0 ? ',' : '\0';
  std::string with_point;
  if (mark == ',') {
    with_point = digits;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    digits = with_point;
  }
  double value = none;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end)
    return {none, '\0', "is too large or too small for a number"};
  if (error != std::errc() || stop != end) {
    if (cell.find(';') != cell.npos || cell.find('\t') != cell.npos)
      return {none, '\0',
              "is not a number; does this row have a different separator from the header?"};
    return {none, '\0', "is not a number"};
  }
  return {value, mark, {}};
}

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const ParsedNumber number = parsed(row, column);
  if (!number.problem.empty())
    throw InputError(fmt::format("{}:{}: {} = {}: {}", source, line(row), header[column],
                                 text::quoted(shown(row, column)), number.problem),
                     {source, line(row), header[column]});
  return number.value;
}

std::string CsvTable::shown(std::size_t row, std::size_t column) const {
  if (!is_numeric(column)) return std::string(cell(row, column));
  const double value = columns_[column].numbers[row];
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

bool CsvTable::is_empty(std::size_t row, std::size_t column) const {
  return is_numeric(column) ? std::isnan(columns_[column].numbers[row]) : cell(row, column).empty();
}

void CsvTable::set_decimal_mark(char mark) {
  marks_ = {.decimal = mark, .thousands = mark == '.' ? ',' : '.'};
}

ParsedNumber CsvTable::parsed(std::size_t row, std::size_t column) const {
  if (!is_numeric(column)) return parsed_text(row, column, cell(row, column));
  const double value = columns_[column].numbers[row];
  if (std::isfinite(value)) return {value, '\0', {}};
  return {std::numeric_limits<double>::quiet_NaN(), '\0',
          std::isnan(value) ? "is empty" : "is not a finite number"};
}

ParsedNumber CsvTable::parsed_text(std::size_t row, std::size_t column,
                                   std::string_view text) const {
  std::string typed;
  if (is_typeset(text)) text = typed = without_typesetting(text);
  const bool decimal_comma = separator != ',' || marks_.decimal == ',';
  if (marks_.asked != '\0' && is_grouped(text, marks_.asked)) {
    std::string plain(text);
    std::erase(plain, marks_.asked);
    const Place place{source, line(row), header[column]};
    throw InputError(
        fmt::format("{}: {} = {}: is it {}, or is the {} a decimal mark? Set decimal_mark = \"{}\" "
                    "or \"{}\" in [columns], or write the file without thousands separators",
                    place.text(), header[column], text, plain,
                    marks_.asked == '.' ? "point" : "comma", marks_.asked == '.' ? ',' : '.',
                    marks_.asked),
        place);
  }
  if (marks_.thousands == '\0' || text.find(marks_.thousands) == text.npos)
    return parse_number(text, decimal_comma);
  const char decimal = marks_.thousands == '.' ? ',' : '.';
  if (!is_grouped(text, marks_.thousands, decimal)) {
    const ParsedNumber number = parse_number(text, decimal_comma);
    if (!number.problem.empty()) return number;
    return {std::numeric_limits<double>::quiet_NaN(), '\0',
            marks_.thousands == '.'
                ? "has a point, but the decimal mark of this file is the comma"
                : "has a comma, but the decimal mark of this file is the point"};
  }
  std::string plain(text);
  std::erase(plain, marks_.thousands);
  return parse_number(plain, decimal_comma);
}

CsvTable table_of_columns(std::string source, std::vector<DataColumn> columns) {
  CsvTable table;
  table.source = std::move(source);
  table.header_line = 1;
  const auto length = [](const DataColumn& column) {
    return std::max(column.numbers.size(), column.texts.size());
  };
  const std::size_t rows = columns.empty() ? 0 : length(columns.front());
  for (const DataColumn& column : columns) {
    if (length(column) != rows)
      throw InputError(fmt::format("{}: column {} has {} values, but column {} has {}",
                                   table.source, printable(column.name), length(column),
                                   printable(columns.front().name), rows),
                       {.file = table.source, .key = printable(column.name)});
    if (column.name.empty())
      throw InputError(table.source + ": a column has no name", {.file = table.source});
    if (table.column(column.name))
      throw InputError(
          fmt::format("{}: two columns are named {}", table.source, printable(column.name)),
          {.file = table.source, .key = column.name});
    const auto refuse_control = [&](const std::string& text) {
      if (const auto code = control_character(text))
        throw InputError(fmt::format("{}: column {} contains the control character {}",
                                     table.source, printable(column.name), *code),
                         {.file = table.source, .key = printable(column.name)});
    };
    refuse_control(column.name);
    for (const std::string& text : column.texts) refuse_control(text);
    table.header.push_back(column.name);
  }
  if (rows == 0) throw InputError(table.source + ": has no rows", {.file = table.source});
  table.lines_.resize(rows);
  std::iota(table.lines_.begin(), table.lines_.end(), 2);
  table.columns_ = std::move(columns);
  table.take_units_out_of_cells();
  return table;
}

CsvTable parse_csv(std::string text, const std::string& source, bool byte_order_mark,
                   const FormFinder& find_form) {
  CsvTable table;
  table.source = source;
  table.byte_order_mark = byte_order_mark;
  if (!is_utf8(text)) {
    text = utf8_from_latin1(text);
    table.notes.emplace_back("the file is not UTF-8; it is read as Latin-1");
  }
  table.text_ = std::move(text);
  std::string& all = table.text_;
  if (all.find_first_not_of(" \t\r\n") == all.npos)
    throw InputError(source + ": the file is empty", {.file = source});
  CsvParser parser(table, all, find_form ? find_form(all) : CsvForm{},
                   find_form ? CsvParser::Origin::others : CsvParser::Origin::this_program,
                   [&](std::span<const CellSpan> cells, int line) {
                     for (const CellSpan& c : cells) table.cells_.push_back({c.begin, c.size});
                     table.lines_.push_back(line);
                   });
  parser.run();
  if (find_form) table.take_units_out_of_cells();
  const std::size_t behind = table.cells_.front().begin;
  table.marks_ = find_decimal_marks(
      table.separator, all.find('.', behind) != all.npos,
      all.find(table.separator == ',' ? '"' : ',', behind) != all.npos, table.rows(),
      table.header.size(),
      [&](std::size_t row, std::size_t column) { return table.cell(row, column); });
  if (table.marks_.thousands != '\0')
    table.notes.push_back(fmt::format("{} are read as thousands separators",
                                      table.marks_.thousands == '.' ? "points" : "commas"));
  parser.add_notes();
  return table;
}

void CsvTable::take_units_out_of_cells() {
  constexpr std::size_t searched = 20;  // rows
  for (std::size_t c = 0; c < header.size(); ++c) {
    // "9 Nm" is the name of a run as it stands.
    if (is_numeric(c) || header[c] == "run_id" || header[c] == "setup_id") continue;
    const auto measured_at = [&](std::size_t row) { return measured_cell(cell(row, c)); };
    std::size_t first = 0;
    while (first < rows() && first < searched && !measured_at(first)) ++first;
    if (first == rows() || first == searched) continue;
    const std::string unit(measured_at(first)->unit);
    const bool stated = c < units.size() && !states_no_unit(units[c]);
    if (stated && find_unit(units[c]) != find_unit(unit)) continue;
    std::vector<std::size_t> in_unit;
    bool is_one = true;
    for (std::size_t row = first; row < rows() && is_one; ++row) {
      const auto here = measured_at(row);
      is_one = !here || here->unit == unit;
      if (here) in_unit.push_back(row);
    }
    // Cells in several units are no numbers, which their reader says.
    if (!is_one) continue;
    for (const std::size_t row : in_unit) {
      const std::size_t size = measured_at(row)->number.size();
      if (columns_.empty())
        cells_[row * header.size() + c].size = size;
      else
        columns_[c].texts[row].resize(size);
    }
    units.resize(header.size());
    units[c] = unit;
    notes.push_back(
        fmt::format("the unit of column {} is taken from its cells: {}", header[c], unit));
  }
}

void CsvTable::remove_rows(const std::vector<bool>& remove) {
  const auto keep = [&](auto& list, std::size_t width) {
    std::size_t kept = 0;
    for (std::size_t row = 0; row < remove.size(); ++row) {
      if (remove[row]) continue;
      std::move(list.begin() + static_cast<std::ptrdiff_t>(row * width),
                list.begin() + static_cast<std::ptrdiff_t>((row + 1) * width),
                list.begin() + static_cast<std::ptrdiff_t>(kept * width));
      ++kept;
    }
    list.resize(kept * width);
  };
  keep(lines_, 1);
  if (columns_.empty()) return keep(cells_, header.size());
  for (DataColumn& column : columns_)
    column.texts.empty() ? keep(column.numbers, 1) : keep(column.texts, 1);
}

CsvTable read_csv(const std::string& path, const FormFinder& find_form) {
  bool marked = false;
  std::string text = read_text(path, &marked);
  return parse_csv(std::move(text), input_name(path), marked, find_form);
}

}  // namespace raceway::text
