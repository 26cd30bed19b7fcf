#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "text/csv.h"

namespace raceway::text {

/// Finds the header of a measurement file in its first lines: the first line with a name that is
/// `known`, else the line above the first row of numbers, if it has as many cells. A line of units
/// alone, below it, is its row of units.
[[nodiscard]] CsvForm find_form(std::string_view text,
                                const std::function<bool(std::string_view)>& known);

/// Returns the separator of a comment that is the header of the row below it: as many cells, all of
/// them names, above a row with at least half readings. Nothing if it is not a header.
[[nodiscard]] std::optional<char> separator_of_commented_header(std::string_view comment,
                                                                std::string_view row);

/// The text of a comment behind its `#`.
[[nodiscard]] std::string_view behind_hash(std::string_view comment);

/// True if a cell is a number with a point or a comma, also with its unit ("12.3 °C"), or a time
/// (text/timestamp.h).
[[nodiscard]] bool is_reading(std::string_view cell);

}  // namespace raceway::text
