#pragma once

#include <functional>
#include <string_view>

#include "text/csv.h"

/// Shared by the readers of CSV files.
namespace raceway::text {

/// True if a number is written in groups of three digits: "1.200" and "12.345.678", with ',' as the
/// decimal mark also "1.200,5". A group in front has no zero first: "0.200" is none.
[[nodiscard]] bool is_grouped(std::string_view cell, char thousands, char decimal = '\0');

/// Meaning of points and commas in a table whose columns are separated by `separator`. A mark is
/// decimal where a cell has it at another place than groups have ("0.5"), and separates thousands
/// where all its cells are groups and the other mark is decimal in other columns. The user must
/// decide where all its cells are groups and nothing else decides: beside a whole number below 1000
/// in the same column (600 and 1.200), or anywhere in a file with semicolons. `points` and
/// `commas`: whether cells may have them at all.
[[nodiscard]] DecimalMarks find_decimal_marks(
    char separator, bool points, bool commas, std::size_t rows, std::size_t columns,
    const std::function<std::string_view(std::size_t row, std::size_t column)>& cell);

}  // namespace raceway::text
