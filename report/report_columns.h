#pragma once

#include <string>
#include <utility>
#include <vector>

namespace raceway::report {

/// Rows of numbers for the pictures of a report, column by column, as compact JSON: seven digits,
/// a column of one value as that value, null where a number is not known.
///
/// A file with more than `most_rows` rows or `most_numbers` numbers is thinned: rows at equal
/// distances stay, and the rows of keep().
class ReportColumns {
 public:
  explicit ReportColumns(std::size_t rows) : rows_(rows) {}

  /// Adds `values` of all rows, in the unit at the end of `name`.
  void add(std::string name, std::vector<double> values);
  /// Keeps these rows too if others are omitted.
  void keep(std::size_t row) { wanted_.push_back(row); }
  /// Keeps the rows with the highest and lowest `values` in each of 500 stretches.
  void keep_extremes(const std::vector<double>& values);
  /// Adds the column and keeps its extremes, for a curve over time.
  void add_course(std::string name, std::vector<double> values) {
    keep_extremes(values);
    add(std::move(name), std::move(values));
  }

  /// `{"total": rows, "rows": those kept, "columns": [{"name": ..., "values": [...]}]}`
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
