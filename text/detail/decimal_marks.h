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
/// mark are grouped and the other mark is decimal in other columns. If all cells with a mark are
/// grouped and no cell has the other mark, the user must state the meaning in two cases: a column
/// has grouped numbers and also a whole number below 1000 (1.200 and 600), or the mark is a point,
/// the separator is a semicolon, and any column has a whole number below 1000. DecimalMarks::asked
/// is then this mark. `points` is true if cells may contain points, `commas` if they may contain
/// commas.
[[nodiscard]] DecimalMarks find_decimal_marks(
    char separator, bool points, bool commas, std::size_t rows, std::size_t columns,
    const std::function<std::string_view(std::size_t row, std::size_t column)>& cell);

}  // namespace raceway::text
