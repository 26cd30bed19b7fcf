#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Lines of a delimited text as cells; shared by the readers of CSV files.
namespace raceway::text {

/// Blanks as separators: any number of them is one.
inline constexpr char blanks = ' ';

/// Place of a cell in a text, without quotes and blanks around it.
struct CellSpan {
  std::size_t begin, size;
};

[[nodiscard]] inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// "semicolons"
[[nodiscard]] std::string_view separator_name(char separator);

/// Separators outside of quotes.
[[nodiscard]] std::size_t count_separators(std::string_view line, char separator);

/// Appends the cells of the line from `begin` to `end`. Doubled quotes are undone in place: the
/// text of a cell can only shrink. Throws InputError for a quote that is not closed on its line;
/// `source` and `line` stand in the message.
void split_cells(std::string& text, std::size_t begin, std::size_t end, char separator,
                 const std::string& source, int line, std::vector<CellSpan>& cells);

/// A number with its unit behind it in one cell, as "12.3 °C".
struct MeasuredCell {
  std::string_view number, unit;
};
/// Nothing where the cell is none, as "1/min" and "8 AM".
[[nodiscard]] std::optional<MeasuredCell> measured_cell(std::string_view cell);

}  // namespace raceway::text
