#include "text/csv_form.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "text/detail/csv_cells.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/timestamp.h"
#include "text/units.h"

namespace raceway::text {
namespace {

constexpr std::size_t searched = 100;  // lines that are no comment
constexpr char tried[] = {'\t', ';', ',', blanks};

struct Line {
  int number;  ///< counted from 1
  std::string_view text;
};

std::vector<Line> first_lines(std::string_view text) {
  std::vector<Line> lines;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size() && lines.size() < searched;) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (end < text.size() && text[end] == '\r' && begin < text.size() && text[begin] == '\n')
      ++begin;
    ++number;
    const std::string_view content = trimmed(line);
    if (!content.empty() && !content.starts_with('#') && !content.starts_with("\"#"))
      lines.push_back({number, line});
  }
  return lines;
}

/// Cells without their quotes; doubled quotes stay, which no name of a column has.
std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == blanks) line = trimmed(line);
  bool inside = false;
  for (std::size_t begin = 0, at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') inside = !inside;
    if (at < line.size() && (inside || line[at] != separator)) continue;
    if (separator == blanks && at == begin) {
      ++begin;
      continue;
    }
    std::string_view cell = trimmed(line.substr(begin, at - begin));
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    begin = at + 1;
  }
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

bool is_unit_row(const std::vector<std::string_view>& cells) {
  std::size_t units = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty() || cell == "-" || cell == "[-]" || cell == "1") continue;
    if (!find_unit(cell)) return false;
    ++units;
  }
  return units > 0;
}

/// The row below a header that is known: half of its cells are units, and none is a reading. What
/// the others are is asked where their columns are read.
bool is_unit_row_below(const std::vector<std::string_view>& cells) {
  std::size_t units = 0, others = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty() || cell == "-" || cell == "[-]" || cell == "1") continue;
    if (is_reading(cell) || is_missing(cell)) return false;
    ++(find_unit(cell) ? units : others);
  }
  return units > 0 && units >= others;
}

bool is_row_of_readings(const std::vector<std::string_view>& cells) {
  const auto numbers =
      static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is_reading));
  return cells.size() > 1 && numbers > 1 && 2 * numbers >= cells.size();
}

bool may_be_header(const std::vector<std::string_view>& cells, std::size_t columns) {
  return cells.size() >= columns && std::none_of(cells.begin(), cells.end(), [](const auto& cell) {
           return cell.empty() || is_reading(cell);
         });
}

/// The header at one of the lines, and the row of units below it.
CsvForm form_at(const std::vector<Line>& lines, std::size_t header, char separator) {
  CsvForm form{.header_line = lines[header].number, .separator = separator};
  if (header + 1 < lines.size() && is_unit_row_below(cells_of(lines[header + 1].text, separator)))
    form.unit_line = lines[header + 1].number;
  return form;
}

}  // namespace

std::string_view behind_hash(std::string_view comment) {
  comment = trimmed(comment);
  const std::size_t begin = comment.find_first_not_of("# \t");
  // A column of row numbers may be named "#".
  if (begin == comment.npos ||
      std::find(std::begin(tried), std::end(tried), comment[begin]) != std::end(tried))
    return comment;
  return comment.substr(begin);
}

namespace {

/// Whether blanks may separate the cells of a row: "600, 200" has commas.
bool may_have_blanks(std::string_view row) {
  return row.find_first_of(";\t") == row.npos && row.find(", ") == row.npos;
}

/// Whether a line has a word for each number of the line below, all between blanks.
bool is_header_between_blanks(const std::vector<Line>& lines, std::size_t k) {
  if (k + 1 >= lines.size() || !may_have_blanks(lines[k + 1].text)) return false;
  const auto names = cells_of(lines[k].text, blanks), cells = cells_of(lines[k + 1].text, blanks);
  return names.size() == cells.size() && is_row_of_readings(cells);
}

}  // namespace

std::optional<char> separator_of_commented_header(std::string_view comment, std::string_view row) {
  const std::string_view names_of = behind_hash(comment);
  const auto separators = [](std::string_view line, char separator) {
    if (separator == blanks) return count_separators(line, blanks);
    return static_cast<std::size_t>(std::count(line.begin(), line.end(), separator));
  };
  const bool single = std::none_of(std::begin(tried), std::end(tried),
                                   [&](char c) { return separators(row, c) > 0; });
  for (const char separator : tried) {
    if (separators(row, separator) != separators(names_of, separator)) continue;
    if (separators(row, separator) == 0 && !(single && separator == ',')) continue;
    if (separator == blanks && !may_have_blanks(row)) continue;
    const auto names = cells_of(names_of, separator), cells = cells_of(row, separator);
    const auto readings = std::count_if(cells.begin(), cells.end(), is_reading);
    if (readings > 0 && 2 * static_cast<std::size_t>(readings) >= cells.size() && !names.empty() &&
        may_be_header(names, cells.size()))
      return separator;
  }
  return std::nullopt;
}

bool is_reading(std::string_view cell) {
  return parse_number(cell, true).problem.empty() || measured_cell(cell) || is_time(cell);
}

CsvForm find_form(std::string_view text, const std::function<bool(std::string_view)>& known) {
  const std::vector<Line> lines = first_lines(text);
  for (std::size_t k = 0; k < lines.size(); ++k)
    for (const char separator : tried) {
      const auto cells = cells_of(lines[k].text, separator);
      if (std::none_of(cells.begin(), cells.end(), known)) continue;
      if (separator == blanks && !is_header_between_blanks(lines, k)) continue;
      CsvForm form = form_at(lines, k, separator);
      // The reader says what is wrong with the separators of a first line.
      if (separator != blanks && (k == 0 || cells.size() == 1)) form.separator = '\0';
      return form;
    }
  for (std::size_t k = 1; k < lines.size(); ++k)
    for (const char separator : tried) {
      const auto cells = cells_of(lines[k].text, separator);
      if (!is_row_of_readings(cells)) continue;
      const bool units = k > 1 && is_unit_row(cells_of(lines[k - 1].text, separator));
      const std::size_t header = k - (units ? 2 : 1);
      if (separator == blanks && (units || !is_header_between_blanks(lines, header))) continue;
      if (!may_be_header(cells_of(lines[header].text, separator), cells.size())) return {};
      CsvForm form = form_at(lines, header, separator);
      if (header == 0 && separator != blanks) form.separator = '\0';
      return form;
    }
  return {};
}

}  // namespace raceway::text
