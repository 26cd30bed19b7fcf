#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "text/csv.h"

namespace raceway::text {

/// Finds the header of a measurement file in the first lines of the file. The header is the first
/// line with a name for which `known` returns true. If no name is known, the header is the line
/// above the first row of numbers, or above the row of units. A header without a known name must
/// have at least as many cells as the first row of numbers. The line below the header is the row of
/// units if at least half of its cells are units and none of its cells is a reading (see
/// is_reading()).
[[nodiscard]] CsvForm find_form(std::string_view text,
                                const std::function<bool(std::string_view)>& known);

/// Returns the separator of a comment line that is a header; empty if the comment is not a header.
/// A comment is a header if all its cells are names, if the row below it has the same number of
/// cells, and if at least half of the cells in this row are readings.
[[nodiscard]] std::optional<char> separator_of_commented_header(std::string_view comment,
                                                                std::string_view row);

/// Returns the text of a comment without the leading `#`.
[[nodiscard]] std::string_view behind_hash(std::string_view comment);

/// Returns true if a cell is a number or a time (text/timestamp.h). The number may have a decimal
/// point or a decimal comma, and a unit ("12.3 °C").
[[nodiscard]] bool is_reading(std::string_view cell);

}  // namespace raceway::text
