#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "files/detail/column_source.h"

/// Finds placeholder numbers in measurement files.
namespace raceway::files {

/// Finds numbers in one column that instruments and loggers write instead of a reading, such as
/// -9999, 9999.9, and 9.9e37 of IEEE 488.2. A number such as -9999 is a placeholder only if it is
/// far outside the range of the usual numbers in the column. In the column of a setting, such as
/// the speed, a positive whole number such as 9999 is not a placeholder. Temperatures and readings
/// outside the allowed range of their channel are placeholders too, if there are at most a tenth as
/// many of them as of other readings. More such numbers indicate another unit.
class ImpossibleCells {
 public:
  /// `with_sign`: true if the values may be negative. `table` and `source` must live longer than
  /// this object.
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
  /// Lowest and highest of the numbers in the column that are not placeholders.
  double lower_ = std::numeric_limits<double>::infinity(), upper_ = -lower_;
};

/// Returns the row indices of placeholder numbers such as -9999 in a column. A number near the
/// range of the usual numbers in the column is not a placeholder.
[[nodiscard]] std::vector<std::size_t> places_of_marks(std::span<const double> numbers);

/// Removes rows with a placeholder number in one of these columns, and returns a note on them;
/// empty if no row was removed. Throws InputError if no row remains.
[[nodiscard]] std::string drop_impossible_rows(text::CsvTable& table,
                                               const std::vector<ColumnSource>& columns);

}  // namespace raceway::files
