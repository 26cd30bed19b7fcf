#pragma once

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/places.h"

namespace raceway::tests {

/// One row of a file in data/reference; cells by column name.
class ReferenceRow {
 public:
  ReferenceRow(std::string place, std::vector<std::string> columns, std::vector<std::string> cells)
      : place_(std::move(place)), columns_(std::move(columns)), cells_(std::move(cells)) {}

  [[nodiscard]] const std::string& text(const std::string& column) const {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i] == column) return cells_[i];
    throw std::runtime_error(place_ + ": no column " + column);
  }
  /// NaN where the cell is empty.
  [[nodiscard]] double operator[](const std::string& column) const {
    const std::string& cell = text(column);
    if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::size_t used = 0;
    const double value = std::stod(cell, &used);
    if (used != cell.size()) throw std::runtime_error(place_ + ": " + column + " = " + cell);
    return value;
  }
  /// File and line, for SCOPED_TRACE.
  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  std::string place_;
  std::vector<std::string> columns_, cells_;
};

/// Reads data/<name>: `#` lines, a header, comma-separated cells; blanks around cells are ignored.
/// Throws where the file is missing, empty or ragged.
inline std::vector<ReferenceRow> data_table(const std::string& name) {
  std::ifstream file(tests::source_dir() + "/data/" + name);
  if (!file) throw std::runtime_error("cannot read data/" + name);
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      const std::string cell = line.substr(begin, end - begin);
      const std::size_t first = cell.find_first_not_of(" \t\r");
      const std::size_t last = cell.find_last_not_of(" \t\r");
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
      begin = end + 1;
    }
    return cells;
  };
  std::vector<std::string> columns;
  std::vector<ReferenceRow> rows;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const std::string place = name + ":" + std::to_string(number);
    const auto cells = split(line);
    if (columns.empty()) {
      columns = cells;
    } else if (cells.size() == columns.size()) {
      rows.emplace_back(place, columns, cells);
    } else {
      throw std::runtime_error(place + ": " + std::to_string(cells.size()) + " cells under " +
                               std::to_string(columns.size()) + " columns");
    }
  }
  if (rows.empty()) throw std::runtime_error("no rows in data/" + name);
  return rows;
}

/// The same of data/reference/<name>.
inline std::vector<ReferenceRow> reference_table(const std::string& name) {
  return data_table("reference/" + name);
}

}  // namespace raceway::tests
