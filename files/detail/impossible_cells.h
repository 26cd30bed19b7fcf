#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "files/detail/column_source.h"

/// Placeholder numbers in measurements; shared by the readers of measurements.
namespace raceway::files {

/// Finds numbers of one column that instruments and loggers write instead of a reading: -9999,
/// 9999.9, and 9.9e37 of IEEE 488.2, if no other reading of the column is near them. Temperatures
/// and readings beyond the range of their channel count too, if they are at most a tenth; a larger
/// share indicates another unit.
class ImpossibleCells {
 public:
  /// `with_sign`: an input that may be below zero here. Both arguments outlive it.
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

/// Returns the positions of such placeholder numbers in a column of the file, if no other number is
/// near them.
[[nodiscard]] std::vector<std::size_t> places_of_marks(std::span<const double> numbers);

/// Removes rows with such a cell in one of these columns, and reports them. Returns nothing if
/// there is none. Throws InputError if no row remains.
[[nodiscard]] std::string drop_impossible_rows(text::CsvTable& table,
                                               const std::vector<ColumnSource>& columns);

}  // namespace raceway::files
