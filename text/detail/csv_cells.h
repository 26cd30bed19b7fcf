#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Cells of the lines of a delimited text; shared by the readers of CSV files.
namespace raceway::text {

/// Blanks as separators: any number of blanks is one separator.
inline constexpr char blanks = ' ';

/// Place of a cell in a text, without surrounding quotes and blanks.
struct CellSpan {
  std::size_t begin, size;
};

[[nodiscard]] inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Returns the name for messages: "semicolons".
[[nodiscard]] std::string_view separator_name(char separator);

/// Returns the number of separators in a line, without separators inside quotes.
[[nodiscard]] std::size_t count_separators(std::string_view line, char separator);

/// Appends the cells of the line from `begin` to `end`. Two quotes ("") inside a quoted cell become
/// one quote. `text` is changed in place. This is possible because a cell can only become shorter.
/// Throws InputError for a quote that is not closed on the same line; `source` and `line` appear in
/// the message.
void split_cells(std::string& text, std::size_t begin, std::size_t end, char separator,
                 const std::string& source, int line, std::vector<CellSpan>& cells);

/// A number and its unit in one cell, such as "12.3 °C".
struct MeasuredCell {
  std::string_view number, unit;
};
/// Reads a cell with a number and a unit. The result is empty for other cells, such as "1/min" and
/// "8 AM".
[[nodiscard]] std::optional<MeasuredCell> measured_cell(std::string_view cell);

}  // namespace raceway::text
