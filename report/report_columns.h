#pragma once

#include <string>
#include <utility>
#include <vector>

namespace raceway::report {

/// Table of numbers for the pictures of a report, written column by column as compact JSON. Numbers
/// have seven significant digits. A column with the same value in all rows has the member
/// `constant` instead of `values`. Unknown numbers are null.
///
/// If the table has more than `most_rows` rows, or more than `most_numbers` numbers outside of
/// constant columns, the output contains only a part of the rows: evenly spaced rows, and the rows
/// selected by keep() or keep_extremes().
class ReportColumns {
 public:
  explicit ReportColumns(std::size_t rows) : rows_(rows) {}

  /// Adds a column with one value for each row. `name` ends with the unit of the values. Throws
  /// std::invalid_argument if the number of values differs from the number of rows.
  void add(std::string name, std::vector<double> values);
  /// Keeps this row even if other rows are omitted.
  void keep(std::size_t row) { wanted_.push_back(row); }
  /// Divides the rows into 500 consecutive sections of nearly equal length. In each section, keeps
  /// the row with the highest and the row with the lowest of `values`.
  void keep_extremes(const std::vector<double>& values);
  /// Adds a column for a curve over time. Calls keep_extremes() to keep the rows with extreme
  /// values of the curve.
  void add_course(std::string name, std::vector<double> values) {
    keep_extremes(values);
    add(std::move(name), std::move(values));
  }

  /// Returns `{"total": rows, "rows": kept rows, "columns": [{"name": ..., "values": [...]}]}`.
  [[nodiscard]] std::string json() const;

  static constexpr std::size_t most_rows = 100000, most_numbers = 1500000;

 private:
  [[nodiscard]] std::vector<std::size_t> kept() const;

  struct Column {
    std::string name;
    std::vector<double> values;
  };
  std::size_t rows_;
  std::vector<Column> columns_;
  std::vector<std::size_t> wanted_;
};

}  // namespace raceway::report
