#include "text/bad_cells.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/error.h"

namespace raceway::text {

void BadCells::add(int line, std::string_view column, std::string_view cell,
                   std::string_view problem) {
  ++count_;
  // Columns are read one by one, so later lines may have come first.
  const auto place = std::upper_bound(first_.begin(), first_.end(), line,
                                      [](int a, const BadCell& b) { return a < b.line; });
  if (first_.size() == shown && place == first_.end()) return;
  const bool number = parse_number(cell, true).problem.empty();
  first_.insert(place, {line, std::string(column),
                        fmt::format("{} = {}: {}", column,
                                    number ? std::string(cell) : quoted(cell), problem)});
  if (first_.size() > shown) first_.pop_back();
}

void BadCells::throw_if_any() const {
  if (count_ == 0) return;
  std::string text;
  for (const BadCell& cell : first_)
    text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", source_, cell.line, cell.text);
  if (count_ > shown)
    text += fmt::format("\n{}: number of further invalid values: {}", source_, count_ - shown);
  if (count_ > 1)
    text += fmt::format("\n{}: {} invalid values in {} rows; correct or remove them", source_,
                        count_, rows_);
  throw InputError(text, {source_, first_.front().line, first_.front().column});
}

ParsedNumber read_cell(const CsvTable& table, std::size_t row, std::size_t column,
                       const CellRange& range, BadCells& bad) {
  ParsedNumber number = table.parsed(row, column);
  if (!number.problem.empty())
    bad.add(table.line(row), range.column, table.shown(row, column), number.problem);
  else if (!(number.value >= range.lower && number.value <= range.upper))
    bad.add(
        table.line(row), range.column, table.shown(row, column),
        fmt::format("must be from {:.10g} to {:.10g} {}", range.lower, range.upper, range.unit));
  return number;
}

}  // namespace raceway::text
