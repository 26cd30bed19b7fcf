#include "text/detail/csv_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "text/csv_form.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/printable.h"
#include "text/units.h"

namespace raceway::text {
namespace {

constexpr char usual_separators[] = {'\t', ';', ','};

char separator_of_header(std::string_view header, const Place& where) {
  char found = '\0';
  for (const char separator : usual_separators) {
    if (count_separators(header, separator) == 0) continue;
    if (found != '\0')
      throw InputError(
          fmt::format("{}: the header has {} and {} as separators; use only one of them",
                      where.text(), separator_name(found), separator_name(separator)),
          where);
    found = separator;
  }
  return found == '\0' ? ',' : found;
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
  const auto says_something = [&](char c) { return c != separator && !is_blank(c); };
  return cells >= columns && cells <= columns + empty_ends &&
         std::any_of(line.begin() + static_cast<std::ptrdiff_t>(end), line.end(), says_something);
}

/// Names that a column has which holds the unit of the one before it.
bool names_unit(std::string_view name) {
  constexpr std::array<std::string_view, 7> names{"",        "unit",      "units", "uom",
                                                  "einheit", "einheiten", "[unit]"};
  // Programs number names that stand twice: "unit.1", "unit_2".
  name = name.substr(0, name.find_last_not_of("0123456789") + 1);
  if (name.ends_with('.') || name.ends_with('_') || name.ends_with(' ')) name.remove_suffix(1);
  return std::find(names.begin(), names.end(), lower_case(name)) != names.end();
}

/// Names of a last column that programs leave out where it is empty.
bool names_remarks(std::string_view name) {
  constexpr std::array<std::string_view, 5> names{"comment", "comments", "kommentar", "bemerkung",
                                                  "remarks"};
  return std::find(names.begin(), names.end(), lower_case(name)) != names.end();
}

std::string plural(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

void CsvParser::run() {
  for (Line line; next(line);) take(line);
  // Nothing came behind them.
  if (!held_.empty() && footer_ == 0) footer_ = held_.front().line;
  if (table_.header.empty())
    throw InputError(table_.source + ": the file has only comments, no header and no rows",
                     {.file = table_.source});
  if (rows_ == 0)
    throw InputError(fmt::format("{}: no data rows below the header (line {})", table_.source,
                                 table_.header_line),
                     place(table_.header_line));
}

bool CsvParser::next(Line& line) {
  if (at_ >= end_) return false;
  line = {.number = ++line_, .begin = at_, .end = std::min(text_.find_first_of("\r\n", at_), end_)};
  at_ = line.end + 1;
  if (line.end < end_ && text_[line.end] == '\r') {
    table_.carriage_returns = true;
    if (at_ < end_ && text_[at_] == '\n') ++at_;
  }
  return true;
}

void CsvParser::take(const Line& line) {
  const std::string_view whole = content(line);
  if (whole.find_first_not_of(" \t") == whole.npos) return;
  if (const auto code = control_character(whole))
    throw InputError(
        fmt::format("{}: the file contains the control character {}, so it is not a text file",
                    place(line.number).text(), *code),
        place(line.number));
  if (is_comment(line)) return take_comment(line);
  if (line.number < form_.header_line) {
    labview_.take(whole);
    ++titles_;
    return;
  }
  if (table_.header.empty() && !take_header(line)) return;
  take_row(line);
}

bool CsvParser::is_comment(const Line& line) const {
  std::string_view text = content(line);
  text.remove_prefix(text.find_first_not_of(" \t"));
  if (!text.starts_with('#') && !text.starts_with("\"#")) return false;
  return table_.header.empty() ||
         !is_row(text, table_.separator, table_.header.size(), empty_ends_);
}

void CsvParser::take_comment(const Line& line) {
  const std::string_view whole = content(line);
  const std::size_t start = whole.find_first_not_of(" \t");
  table_.comments.emplace_back(whole.substr(start));
  comment_ = {line.number, line.begin + start, line.end};
}

/// True where the header stood in a comment above, so that the line is the first row.
bool CsvParser::take_header(const Line& line) {
  const std::string_view first = trimmed(content(line));
  const auto commented = table_.comments.empty()
                             ? std::nullopt
                             : separator_of_commented_header(table_.comments.back(), first);
  if (!commented) {
    table_.separator = form_.separator != '\0'
                           ? form_.separator
                           : separator_of_header(content(line), place(line.number));
    read_header(line);
    return false;
  }
  table_.separator = *commented;
  const std::string_view names = behind_hash(table_.comments.back());
  const std::size_t begin =
      comment_.begin + static_cast<std::size_t>(names.data() - table_.comments.back().data());
  const Line header{comment_.number, begin, begin + names.size()};
  table_.comments.pop_back();
  at_ = line.begin;  // the line is looked at again, behind its header
  --line_;
  read_header(header);
  Line again;
  next(again);
  return true;
}

void CsvParser::read_header(const Line& line) {
  table_.header_line = line.number;
  std::vector<CellSpan> names;
  split_cells(text_, line.begin, line.end, table_.separator, table_.source, line.number, names);
  find_unit_columns(names, line);
  while (names.size() > 1 && names.back().size == 0) names.pop_back(), ++empty_ends_;
  for (const CellSpan& name : names) table_.header.emplace_back(text_of(name));
  check_names(line.number);
}

void CsvParser::check_names(int line) {
  std::vector<std::string>& header = table_.header;
  constexpr std::size_t most_columns = 10000;
  const Place where = place(line);
  if (header.size() > most_columns)
    throw InputError(fmt::format("{}: the file has {} columns; at most {} are allowed",
                                 where.text(), header.size(), most_columns),
                     where);
  // Row numbers, as pandas writes them.
  if (header.front().empty() && header.size() > 1) header.front() = "column 1";
  std::unordered_map<std::string_view, std::size_t> seen;
  bool all_numbers = true;
  for (std::size_t k = 0; k < header.size(); ++k) {
    const std::string& name = header[k];
    if (name.empty())
      throw InputError(fmt::format("{}: column {} has no name", where.text(), k + 1), where);
    const bool is_number = parse_number(name, true).problem.empty();
    // Equal numbers side by side are rows without a header, told below.
    const auto [twin, is_new] = seen.emplace(name, k + 1);
    if (!is_new && !is_number)
      throw InputError(fmt::format("{}: column {} occurs twice, as columns {} and {}", where.text(),
                                   name, twin->second, k + 1),
                       {table_.source, line, name});
    all_numbers = all_numbers && is_number;
  }
  if (all_numbers)
    throw InputError(where.text() + ": the header line with the column names is missing", where);
}

/// Columns without a name of their own that hold the unit of the column before them, as the line
/// behind the header shows. They leave the names.
void CsvParser::find_unit_columns(std::vector<CellSpan>& names, const Line& header) {
  if (origin_ == Origin::this_program) return;
  if (std::none_of(names.begin() + 1, names.end(),
                   [&](const CellSpan& name) { return names_unit(text_of(name)); }))
    return;
  CsvParser ahead = *this;
  Line line;
  std::string row;
  while (row.empty() && ahead.next(line))
    if (line.number > header.number) row = trimmed(content(line));
  std::vector<CellSpan> cells;
  split_cells(row, 0, row.size(), table_.separator, table_.source, line.number, cells);
  if (cells.size() != names.size()) return;
  const auto cell = [&](std::size_t k) {
    return std::string_view(row).substr(cells[k].begin, cells[k].size);
  };
  std::vector<bool> is_unit(names.size());
  bool any = false;
  for (std::size_t k = 1; k < names.size(); ++k) {
    is_unit[k] = names_unit(text_of(names[k])) && !is_unit[k - 1] &&
                 (states_no_unit(cell(k)) || find_unit(cell(k)));
    any = any || (is_unit[k] && find_unit(cell(k)));
  }
  if (!any) return;
  is_unit_ = std::move(is_unit);
  std::size_t k = 0;
  std::erase_if(names, [&](const CellSpan&) { return is_unit_[k++]; });
}

/// Takes the columns of units out of a row. One column has one unit.
void CsvParser::take_units(std::vector<CellSpan>& cells, int line) {
  if (is_unit_.empty() || cells.size() < is_unit_.size()) return;
  table_.units.resize(table_.header.size());
  for (std::size_t k = 0, named = 0; k < is_unit_.size(); ++k) {
    if (!is_unit_[k]) {
      ++named;
      continue;
    }
    std::string& unit = table_.units[named - 1];
    const std::string_view here = text_of(cells[k]);
    if (states_no_unit(here) || unit == here) continue;
    if (find_unit(here) && find_unit(here) == find_unit(unit)) continue;
    if (!unit.empty())
      throw InputError(
          fmt::format("{}: the unit of {} is {} in this row, but {} in the rows above; use one "
                      "unit in a column",
                      place(line).text(), table_.header[named - 1], printable(here), unit),
          place(line));
    unit = here;
  }
  std::size_t k = 0;
  std::erase_if(cells, [&](const CellSpan&) { return k < is_unit_.size() && is_unit_[k++]; });
}

void CsvParser::take_row(const Line& line) {
  cells_.clear();
  split_cells(text_, line.begin, line.end, table_.separator, table_.source, line.number, cells_);
  if (line.number == form_.unit_line) {
    table_.units.clear();
    for (const CellSpan& cell : cells_) table_.units.emplace_back(text_of(cell));
    return;
  }
  const auto is_empty = [](const CellSpan& c) { return c.size == 0; };
  if (std::all_of(cells_.begin(), cells_.end(), is_empty)) {
    ++empty_rows_;
    return;
  }
  if (is_header(cells_)) {
    ++headers_again_;
    behind_header_ = true;
    // A logger that began anew: what it wrote at its end and at its beginning is no end of the
    // file.
    lines_between_ += held_.size() + (footer_ > 0 ? footers_ : 0);
    held_.clear();
    footer_ = 0;
    footers_ = 0;
    return;
  }
  if (std::exchange(behind_header_, false) && is_unit_row_again(line.number)) return;
  take_units(cells_, line.number);
  fit_to_header(cells_);
  if (cells_.size() != table_.header.size()) {
    if (!is_footer(cells_)) refuse(cells_, line);
    if (footer_ == 0) footer_ = line.number;
    ++footers_;
    return;
  }
  constexpr std::size_t most_statistics = 10;
  if (may_be_statistics(cells_) && held_.size() < most_statistics) {
    held_.push_back({cells_, line.number});
    return;
  }
  if (footer_ > 0)
    throw InputError(fmt::format("{}: this row has fewer cells than the header (line {})",
                                 place(footer_).text(), table_.header_line),
                     place(footer_));
  give_held();
  give(cells_, line.number);
}

/// The row of units where it stands again. Throws InputError where it has other ones.
bool CsvParser::is_unit_row_again(int line) const {
  if (form_.unit_line == 0) return false;
  const auto unit_in = [&](std::size_t k) {
    return k < cells_.size() ? text_of(cells_[k]) : std::string_view();
  };
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (is_reading(unit_in(k)) && !find_unit(unit_in(k))) return false;
  for (std::size_t k = 0; k < table_.units.size(); ++k) {
    const std::string_view here = unit_in(k), above = table_.units[k];
    if (here == above || (find_unit(here) && find_unit(here) == find_unit(above))) continue;
    if (!find_unit(here) && !find_unit(above)) return false;
    throw InputError(
        fmt::format("{}: the unit of {} is {} in this row, but {} in the rows above; use one unit "
                    "in a column",
                    place(line).text(), k < table_.header.size() ? table_.header[k] : "",
                    quoted(here), quoted(above)),
        place(line));
  }
  return true;
}

/// Empty cells at the end come and go; the time of a LabVIEW file comes from its head.
void CsvParser::fit_to_header(std::vector<CellSpan>& cells) {
  const std::size_t columns = table_.header.size();
  while (cells.size() > columns && cells.back().size == 0) cells.pop_back();
  if (cells.size() + 1 == columns && names_remarks(table_.header.back()))
    cells.push_back({cells.back().begin + cells.back().size, 0});
  if (table_.header.front() != LabviewHead::column || cells.front().size > 0) return;
  if (const auto time = labview_.time_of(rows_)) {
    cells.front() = {text_.size(), time->size()};
    text_ += *time;
  }
}

bool CsvParser::is_header(const std::vector<CellSpan>& cells) const {
  const std::size_t columns = table_.header.size() + (is_unit_.empty() ? 0 : is_unit_.size());
  if (cells.size() > columns + empty_ends_) return false;
  std::size_t named = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k < is_unit_.size() && is_unit_[k]) continue;
    if (named == table_.header.size()) {
      if (cells[k].size > 0) return false;
      continue;
    }
    if (text_of(cells[k]) != table_.header[named++]) return false;
  }
  return named == table_.header.size();
}

/// Words behind the rows, fewer than there are columns.
bool CsvParser::is_footer(const std::vector<CellSpan>& cells) const {
  return rows_ > 0 && cells.size() < table_.header.size() &&
         std::none_of(cells.begin(), cells.end(), [&](const CellSpan& c) {
           return parse_number(text_of(c), false).problem.empty();
         });
}

/// "Mean,4000,25.3" or "End of data,," below rows that begin with a reading.
bool CsvParser::may_be_statistics(const std::vector<CellSpan>& cells) const {
  constexpr std::array<std::string_view, 22> words{
      "average", "avg", "mean",    "median",     "min",   "max",    "minimum",
      "maximum", "std", "std dev", "stdev",      "sd",    "sum",    "total",
      "count",   "end", "mittel",  "mittelwert", "summe", "anzahl", "standardabweichung",
      "ende"};
  const std::string_view first = text_of(cells.front());
  if (!begins_with_reading_ || first.empty() || (first.front() & 0x40) == 0) return false;
  return std::find(words.begin(), words.end(), lower_case(first)) != words.end() ||
         (!is_missing(first) && !is_reading(first) &&
          std::all_of(cells.begin() + 1, cells.end(),
                      [](const CellSpan& c) { return c.size == 0; }));
}

void CsvParser::give(const std::vector<CellSpan>& cells, int line) {
  if (rows_++ == 0) begins_with_reading_ = is_reading(text_of(cells.front()));
  give_row_(cells, line);
}

void CsvParser::give_held() {
  for (const Row& row : held_) give(row.cells, row.line);
  held_.clear();
}

void CsvParser::refuse(const std::vector<CellSpan>& cells, const Line& line) const {
  const std::size_t columns = table_.header.size();
  const std::string here = place(line.number).text();
  for (const char other : usual_separators) {
    if (other == table_.separator) continue;
    const std::size_t count = count_separators(content(line), other);
    if (count == 0 || count + 1 != columns) continue;
    throw InputError(fmt::format("{}: the header (line {}) has {} as separators, but this row has "
                                 "{}; use the same separator",
                                 here, table_.header_line, separator_name(table_.separator),
                                 separator_name(other)),
                     place(line.number));
  }
  const bool all_numbers = std::all_of(cells.begin(), cells.end(), [&](const CellSpan& c) {
    return parse_number(text_of(c), false).problem.empty();
  });
  throw InputError(
      fmt::format("{}: {}, but the header (line {}) has {}{}", here, plural(cells.size(), "cell"),
                  table_.header_line, plural(columns, "column"),
                  all_numbers && table_.separator == ',' && cells.size() > columns
                      ? " (numbers with decimal commas need semicolons or tabs between the columns)"
                      : ""),
      place(line.number));
}

void CsvParser::add_notes() {
  std::vector<std::string>& notes = table_.notes;
  if (titles_ > 0)
    notes.push_back(fmt::format("the program skips {} above the header (line {})",
                                plural(titles_, "line"), table_.header_line));
  if (form_.unit_line > 0)
    notes.push_back(fmt::format("line {} is a row of units", form_.unit_line));
  if (headers_again_ > 0)
    notes.push_back(
        fmt::format("the header occurs {} more in the file; the program skips each repetition",
                    headers_again_ == 1 ? "once" : fmt::format("{} times", headers_again_)));
  if (lines_between_ > 0)
    notes.push_back(fmt::format("the program skips {} between the rows and the repeated header",
                                plural(lines_between_, "line")));
  if (footer_ > 0)
    notes.push_back(
        fmt::format("the program skips the text after the rows, from line {} on", footer_));
  if (empty_rows_ > 0)
    notes.push_back(
        fmt::format("the program skips {} with only empty cells", plural(empty_rows_, "row")));
}

}  // namespace raceway::text
