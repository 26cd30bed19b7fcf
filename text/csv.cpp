#include "text/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "text/csv_form.h"
#include "text/detail/csv_text.h"
#include "text/detail/decimal_marks.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/printable.h"
#include "text/text_encoding.h"

namespace raceway::text {
namespace {

constexpr char separators[] = {'\t', ';', ','};

std::string_view separator_name(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    default:
      return "commas";
  }
}

bool blank(char c) { return c == ' ' || c == '\t'; }

/// Separators outside quotes.
std::size_t count_separators(std::string_view line, char separator) {
  bool inside = false;
  std::size_t count = 0;
  for (const char c : line) {
    if (c == '"') inside = !inside;
    if (c == separator && !inside) ++count;
  }
  return count;
}

char separator_of_header(std::string_view header, const std::string& place, const Place& where) {
  char found = '\0';
  for (const char separator : separators) {
    if (count_separators(header, separator) == 0) continue;
    if (found != '\0')
      throw InputError(fmt::format("{}: the header is separated by {} and by {}; use one of them",
                                   place, separator_name(found), separator_name(separator)),
                       where);
    found = separator;
  }
  return found == '\0' ? ',' : found;
}

/// Signs and separators as texts have them and programs do not.
bool is_typeset(std::string_view number) {
  return std::any_of(number.begin(), number.end(),
                     [](char c) { return c == '\'' || c == ' ' || (c & 0x80) != 0; });
}

/// With "-" for U+2212, the sign at the number ("- 5"), and no apostrophes between groups of three
/// digits (1'200.5).
std::string without_typesetting(std::string_view number) {
  std::string text(number);
  for (const auto& [typeset, plain] :
       {std::pair<std::string_view, std::string_view>{"\u2212", "-"}, {"\u2019", "'"}})
    for (std::size_t at = text.find(typeset); at != text.npos; at = text.find(typeset))
      text.replace(at, typeset.size(), plain);
  if (text.starts_with('-') || text.starts_with('+'))
    text.erase(1, text.find_first_not_of(' ', 1) - 1);
  if (is_grouped(text, '\'', '.') || is_grouped(text, '\'', ',')) std::erase(text, '\'');
  return text;
}

/// A line below the header that begins with `#`: a row where its cells fit and say something, or
/// where the first one is an error of a spreadsheet; else a comment. A model stands behind "#|".
bool is_row(std::string_view line, char separator, std::size_t columns, std::size_t empty_ends) {
  if (line.starts_with("#|")) return false;
  const std::size_t end = line.find(separator);
  std::string_view first = trimmed(line.substr(0, end));
  if (first.size() > 1 && first.front() == '"' && first.back() == '"')
    first = first.substr(1, first.size() - 2);
  if (is_missing(first)) return true;
  if (end == line.npos) return false;
  const std::size_t cells = count_separators(line, separator) + 1;
  const auto says_something = [&](char c) { return c != separator && !blank(c); };
  return cells >= columns && cells <= columns + empty_ends &&
         std::any_of(line.begin() + static_cast<std::ptrdiff_t>(end), line.end(), says_something);
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
            "has a decimal comma, which is read only in files separated by semicolons or tabs"};
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
    return {none, '\0', "is outside the range of numbers"};
  if (error != std::errc() || stop != end) {
    if (cell.find(';') != cell.npos || cell.find('\t') != cell.npos)
      return {none, '\0', "is not a number; is this row separated otherwise than the header?"};
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
                                 quoted(shown(row, column)), number.problem),
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
        fmt::format("{}: {} = {}: is it {}, or is the {} a decimal mark? Say decimal_mark = \"{}\" "
                    "or \"{}\" in [columns], or write the file without separators of thousands",
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
            marks_.thousands == '.' ? "has a point where commas are decimal marks"
                                    : "has a comma where points are decimal marks"};
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
      throw InputError(fmt::format("{}: column {} has {} values, and {} has {}", table.source,
                                   printable(column.name), length(column),
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
        throw InputError(fmt::format("{}: column {} holds the control character {}", table.source,
                                     printable(column.name), *code),
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
  return table;
}

CsvTable parse_csv(std::string text, const std::string& source, bool byte_order_mark,
                   const FormFinder& find_form) {
  CsvTable table;
  table.source = source;
  table.byte_order_mark = byte_order_mark;
  if (!is_utf8(text)) {
    text = utf8_from_latin1(text);
    table.notes.emplace_back("not UTF-8; read as Latin-1");
  }
  table.text_ = std::move(text);
  std::string& all = table.text_;
  if (all.find_first_not_of(" \t\r\n") == all.npos)
    throw InputError(source + ": the file is empty", {.file = source});
  const CsvForm form = find_form ? find_form(all) : CsvForm{};

  std::vector<CsvTable::Cell> cells;  // of the current line
  int line = 0;
  const auto split = [&](std::size_t begin, std::size_t end, const std::string& place) {
    cells.clear();
    const char separator = table.separator;
    for (std::size_t at = begin;;) {
      const auto skippable = [&](char c) { return c != separator && blank(c); };
      while (at < end && skippable(all[at])) ++at;
      std::size_t first = at, last;
      if (at < end && all[at] == '"') {
        // Doubled quotes are undone in place; the text can only shrink.
        first = ++at;
        last = first;
        for (;; ++at) {
          if (at >= end)
            throw InputError(place + ": a quoted cell is not closed on its line",
                             {.file = source, .line = line});
          if (all[at] == '"') {
            if (at + 1 < end && all[at + 1] == '"')
              ++at;
            else
              break;
          }
          all[last++] = all[at];
        }
        ++at;
        while (at < end && skippable(all[at])) ++at;
        if (at < end && all[at] != separator)
          throw InputError(place + ": text follows the closing quote of a cell",
                           {.file = source, .line = line});
      } else {
        at = std::min(all.find(separator, at), end);
        last = at;
        while (last > first && blank(all[last - 1])) --last;
      }
      const std::size_t size =
          without_guard(std::string_view(all).substr(first, last - first)).size();
      cells.push_back({last - size, size});
      if (at >= end) return;
      ++at;
    }
  };

  std::size_t empty_ends = 0;  // separators behind the last name
  std::size_t empty_rows = 0, headers_again = 0;
  int footer = 0;  // line of the first one
  int titles = 0;
  struct {
    int line = 0;
    std::size_t begin = 0;
  } comment;  // the last one
  const auto read_header = [&](int at_line, std::size_t first, std::size_t last) {
    table.header_line = at_line;
    const std::string place = fmt::format("{}:{}", source, at_line);
    split(first, last, place);
    while (cells.size() > 1 && cells.back().size == 0) cells.pop_back(), ++empty_ends;
    constexpr std::size_t most = 10000;
    if (cells.size() > most)
      throw InputError(
          fmt::format("{}: {} columns: at most {} are read", place, cells.size(), most),
          {.file = source, .line = at_line});
    std::unordered_map<std::string, std::size_t> seen;
    bool all_numbers = true;
    for (const auto& cell : cells) {
      std::string name = all.substr(cell.begin, cell.size);
      const std::size_t position = table.header.size() + 1;
      // Row numbers, as pandas writes them.
      if (name.empty() && position == 1 && cells.size() > 1) name = "column 1";
      if (name.empty())
        throw InputError(fmt::format("{}: column {} has no name", place, position),
                         {.file = source, .line = at_line});
      // Equal numbers side by side are rows without a header, told below.
      const auto [twin, is_new] = seen.emplace(name, position);
      if (!is_new && !parse_number(name, true).problem.empty())
        throw InputError(fmt::format("{}: column {} stands twice, as columns {} and {}", place,
                                     name, twin->second, position),
                         {source, at_line, name});
      all_numbers = all_numbers && parse_number(name, true).problem.empty();
      table.header.push_back(name);
    }
    if (all_numbers)
      throw InputError(place + ": a header with the names of the columns is missing",
                       {.file = source, .line = at_line});
  };
  for (std::size_t begin = 0, next = 0; begin < all.size(); begin = next) {
    ++line;
    std::size_t end = std::min(all.find_first_of("\r\n", begin), all.size());
    next = end + 1;
    if (end < all.size() && all[end] == '\r') {
      table.carriage_returns = true;
      if (next < all.size() && all[next] == '\n') ++next;
    }
    const std::string_view whole = std::string_view(all).substr(begin, end - begin);
    const std::size_t start = whole.find_first_not_of(" \t");
    if (start == whole.npos) continue;
    if (const auto code = control_character(whole))
      throw InputError(
          fmt::format("{}:{}: holds the control character {}, so it is not a text file", source,
                      line, *code),
          {.file = source, .line = line});
    if ((whole[start] == '#' || whole.substr(start).starts_with("\"#")) &&
        (table.header.empty() ||
         !is_row(whole.substr(start), table.separator, table.header.size(), empty_ends))) {
      table.comments.emplace_back(whole.substr(start));
      comment = {line, begin + start};
      continue;
    }
    if (line < form.header_line) {
      ++titles;
      continue;
    }
    const std::string place = table.header.empty() ? fmt::format("{}:{}", source, line) : "";

    if (table.header.empty()) {
      const auto commented =
          table.comments.empty()
              ? std::nullopt
              : separator_of_commented_header(table.comments.back(), whole.substr(start));
      if (commented) {
        table.separator = *commented;
        const std::string_view names = behind_hash(table.comments.back());
        const std::size_t first =
            comment.begin + static_cast<std::size_t>(names.data() - table.comments.back().data());
        read_header(comment.line, first, first + names.size());
        table.comments.pop_back();
      } else {
        table.separator = form.separator != '\0'
                              ? form.separator
                              : separator_of_header(whole, place, {.file = source, .line = line});
        read_header(line, begin, end);
        continue;
      }
    }

    const std::size_t columns = table.header.size();
    // The place is only put into words where something is wrong.
    if (std::find(whole.begin(), whole.end(), '"') != whole.end())
      split(begin, end, fmt::format("{}:{}", source, line));
    else
      split(begin, end, {});
    for (std::size_t k = 0; k < empty_ends && cells.size() > columns && cells.back().size == 0; ++k)
      cells.pop_back();
    if (line == form.unit_line) {
      for (const auto& cell : cells) table.units.push_back(all.substr(cell.begin, cell.size));
      continue;
    }
    if (std::all_of(cells.begin(), cells.end(), [](const auto& c) { return c.size == 0; })) {
      ++empty_rows;
      continue;
    }
    const auto text_of = [&](const auto& c) {
      return std::string_view(all).substr(c.begin, c.size);
    };
    if (std::equal(cells.begin(), cells.end(), table.header.begin(), table.header.end(),
                   [&](const auto& c, const std::string& name) { return text_of(c) == name; })) {
      ++headers_again;
      continue;
    }
    if (cells.size() != columns) {
      const std::string here = fmt::format("{}:{}", source, line);
      for (const char other : separators) {
        if (other == table.separator) continue;
        const std::size_t count = count_separators(whole, other);
        if (count == 0 || count + 1 != columns) continue;
        throw InputError(
            fmt::format(
                "{}: the header (line {}) is separated by {}, but this row by {}; use one for both",
                here, table.header_line, separator_name(table.separator), separator_name(other)),
            {.file = source, .line = line});
      }
      const auto is_number = [&](const auto& c) {
        return parse_number(text_of(c), false).problem.empty();
      };
      const bool all_numbers = std::all_of(cells.begin(), cells.end(), is_number);
      // Words behind the rows are a footer, if no row comes behind them.
      if (!table.lines_.empty() && cells.size() < columns &&
          std::none_of(cells.begin(), cells.end(), is_number)) {
        if (footer == 0) footer = line;
        continue;
      }
      throw InputError(
          fmt::format(
              "{}: {} cell{}, but the header (line {}) has {} column{}{}", here, cells.size(),
              cells.size() == 1 ? "" : "s", table.header_line, columns, columns == 1 ? "" : "s",
              all_numbers && table.separator == ',' && cells.size() > columns
                  ? " (numbers with decimal commas need semicolons or tabs between the columns)"
                  : ""),
          {.file = source, .line = line});
    }
    if (footer > 0)
      throw InputError(fmt::format("{}:{}: fewer cells than the header (line {}) has columns",
                                   source, footer, table.header_line),
                       {.file = source, .line = footer});
    table.cells_.insert(table.cells_.end(), cells.begin(), cells.end());
    table.lines_.push_back(line);
  }
  if (table.header.empty())
    throw InputError(source + ": no header and no rows, only comments", {.file = source});
  if (table.lines_.empty())
    throw InputError(
        fmt::format("{}: no data rows below the header (line {})", source, table.header_line),
        {.file = source, .line = table.header_line});
  const std::size_t behind = table.cells_.front().begin;
  table.marks_ = find_decimal_marks(
      table.separator, all.find('.', behind) != all.npos,
      all.find(table.separator == ',' ? '"' : ',', behind) != all.npos, table.rows(),
      table.header.size(),
      [&](std::size_t row, std::size_t column) { return table.cell(row, column); });
  if (table.marks_.thousands != '\0')
    table.notes.push_back(
        fmt::format("{} separate thousands", table.marks_.thousands == '.' ? "points" : "commas"));
  if (titles > 0)
    table.notes.push_back(fmt::format("{} line{} above the header (line {}) skipped", titles,
                                      titles == 1 ? "" : "s", table.header_line));
  if (form.unit_line > 0)
    table.notes.push_back(fmt::format("line {} is a row of units", form.unit_line));
  if (headers_again > 0)
    table.notes.push_back(
        fmt::format("the header stands {} more and is skipped there",
                    headers_again == 1 ? "once" : fmt::format("{} times", headers_again)));
  if (footer > 0)
    table.notes.push_back(
        fmt::format("the text behind the rows, from line {} on, is skipped", footer));
  if (empty_rows > 0)
    table.notes.push_back(fmt::format("{} row{} of empty cells only skipped", empty_rows,
                                      empty_rows == 1 ? "" : "s"));
  return table;
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
