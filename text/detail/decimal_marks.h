#pragma once

#include <functional>
#include <string_view>

#include "text/csv.h"

/// Decimal and thousands marks; shared by the readers of CSV files.
namespace raceway::text {

/// Returns true if a number is written in groups of three digits, such as "1.200" and "12.345.678",
/// and "1.200,5" if ',' is the decimal mark. The first group must not begin with zero, so "0.200"
/// is not grouped.
[[nodiscard]] bool is_grouped(std::string_view cell, char thousands, char decimal = '\0');

/// Finds the meaning of points and commas in a table with this `separator`. A mark is decimal if a
/// cell has it outside of digit groups ("0.5"). A mark separates thousands if all cells with this
/// mark are grouped and the other mark is decimal in other columns. If all cells with the mark are
/// grouped and no other cell shows its meaning, the user must state the meaning. This is the case
/// if the same column also has a whole number below 1000 (600 and 1.200), or, for points in a file
/// with semicolons, if any column has such a number. `points` and `commas`: true if cells may have
/// this mark.
[[nodiscard]] DecimalMarks find_decimal_marks(
    char separator, bool points, bool commas, std::size_t rows, std::size_t columns,
    const std::function<std::string_view(std::size_t row, std::size_t column)>& cell);

}  // namespace raceway::text
