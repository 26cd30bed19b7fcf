#include "text/spreadsheet_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "text/csv.h"
#include "text/detail/csv_cells.h"
#include "text/detail/csv_text.h"

namespace raceway::text {
namespace {

void append_cell(fmt::memory_buffer& out, std::string_view cell, SpreadsheetMarks marks) {
  if (!parse_number(cell, false).problem.empty()) return append_text(out, cell);
  std::string number(cell);
  std::replace(number.begin(), number.end(), '.', marks.decimal);
  out.append(number.data(), number.data() + number.size());
}

}  // namespace

PlainCsv plain_csv(std::string_view csv) {
  PlainCsv result;
  while (!csv.empty()) {
    const std::size_t end = std::min(csv.find('\n'), csv.size() - 1) + 1;
    (csv.starts_with('#') ? result.comments : result.table) += csv.substr(0, end);
    csv.remove_prefix(end);
  }
  return result;
}

PlainCsv spreadsheet_csv(std::string_view csv, SpreadsheetMarks marks) {
  if (marks.separator == marks.decimal)
    throw std::invalid_argument("the column separator and the decimal mark must be different");
  PlainCsv result = plain_csv(csv);
  std::string_view rows = result.table;
  fmt::memory_buffer out;
  const std::string_view byte_order_mark = "\xEF\xBB\xBF", end_of_line = "\r\n";
  out.append(byte_order_mark.data(), byte_order_mark.data() + byte_order_mark.size());
  std::vector<CellSpan> cells;
  for (int number = 1; !rows.empty(); ++number) {
    const std::size_t end = std::min(rows.find('\n'), rows.size());
    std::string line(rows.substr(0, end));
    rows.remove_prefix(std::min(end + 1, rows.size()));
    cells.clear();
    split_cells(line, 0, line.size(), ',', "table", number, cells);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (k > 0) out.push_back(marks.separator);
      append_cell(out, std::string_view(line).substr(cells[k].begin, cells[k].size), marks);
    }
    out.append(end_of_line.data(), end_of_line.data() + end_of_line.size());
  }
  result.table = fmt::to_string(out);
  return result;
}

}  // namespace raceway::text
