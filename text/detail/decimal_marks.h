#pragma once

#include <functional>
#include <string_view>

#include "text/csv.h"

/// Shared by the readers of CSV files.
namespace raceway::text {

/// True if a number is written in groups of three digits: "1.200" and "12.345.678", with ',' as the
/// decimal mark also "1.200,5". A group in front has no zero first: "0.200" is none.
[[nodiscard]] bool is_grouped(std::string_view cell, char thousands, char decimal = '\0');

/// Finds the meaning of points and commas in a table with this `separator`. A mark is decimal if a
/// cell has it outside of digit groups ("0.5"). It separates thousands if all its cells are groups
/// and the other mark is decimal in other columns. The user must decide if all its cells are groups
/// and nothing else decides: next to a whole number below 1000 in the same column (600 and 1.200),
/// or anywhere in a file with semicolons. `points` and `commas`: true if cells may have them.
[[nodiscard]] DecimalMarks find_decimal_marks(
    char separator, bool points, bool commas, std::size_t rows, std::size_t columns,
    const std::function<std::string_view(std::size_t row, std::size_t column)>& cell);

}  // namespace raceway::text
