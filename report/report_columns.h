#pragma once

#include <string>
#include <utility>
#include <vector>

namespace raceway::report {

/// Table of numbers for the pictures of a report, written column by column as compact JSON. Numbers
/// have seven significant digits. A column with the same value in all rows has the member
/// `constant` instead of `values`. Unknown numbers are null.
///
/// If there are more than `most_rows` rows, or more than `most_numbers` numbers in columns that
/// vary, rows are omitted. Evenly spaced rows and the rows of keep() remain.
class ReportColumns {
 public:
  explicit ReportColumns(std::size_t rows) : rows_(rows) {}

  /// Adds a column with one value for each row, in the unit at the end of `name`. Throws
  /// std::invalid_argument if the number of values differs from the number of rows.
  void add(std::string name, std::vector<double> values);
  /// Keeps this row even if other rows are omitted.
  void keep(std::size_t row) { wanted_.push_back(row); }
  /// Keeps the rows with the highest and the lowest of `values` in each of 500 consecutive sections
  /// with nearly equal numbers of rows.
  void keep_extremes(const std::vector<double>& values);
  /// Adds a column for a curve over time, and keeps its extremes by keep_extremes().
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
