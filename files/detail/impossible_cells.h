#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "files/detail/column_source.h"

/// Placeholder numbers in measurements; shared by the readers of measurements.
namespace raceway::files {

/// Finds numbers in one column that instruments and loggers write instead of a reading: -9999,
/// 9999.9, and 9.9e37 of IEEE 488.2. A number is found only if no other reading of the column is
/// near it. Temperatures and readings outside the range of their channel are found too, if they are
/// at most a tenth of the other readings. A larger share indicates another unit.
class ImpossibleCells {
 public:
  /// `with_sign`: the input may be negative. The table and the source must live longer than this
  /// object.
  ImpossibleCells(const text::CsvTable& table, const ColumnSource& source, bool with_sign);

  [[nodiscard]] bool has(std::size_t row);

 private:
  [[nodiscard]] bool may_be(std::size_t row) const;
  [[nodiscard]] bool is_beyond(double value) const;
  void look();

  const text::CsvTable& table_;
  const ColumnSource& source_;
  text::CellRange range_;
  bool judges_range_;
  bool looked_ = false, few_beyond_ = false;
  /// Range of all other numbers.
  double lower_ = std::numeric_limits<double>::infinity(), upper_ = -lower_;
};

/// Returns the positions of placeholder numbers in a column of the file. A number near other
/// numbers of the column is not a placeholder.
[[nodiscard]] std::vector<std::size_t> places_of_marks(std::span<const double> numbers);

/// Removes rows with a placeholder number in one of these columns, and returns a report on them;
/// empty if there are none. Throws InputError if no row remains.
[[nodiscard]] std::string drop_impossible_rows(text::CsvTable& table,
                                               const std::vector<ColumnSource>& columns);

}  // namespace raceway::files
