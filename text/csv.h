#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/error.h"

namespace raceway::text {

/// Position of the header and of the row of units in a delimited text file.
struct CsvForm {
  int header_line = 0;    ///< counted from 1; 0: the first line. Lines above the header are skipped
  int unit_line = 0;      ///< row of units below the header; 0: no such row
  char separator = '\0';  ///< '\0': the parser finds the separator
};

/// A number, or the reason why a cell is not a number.
struct ParsedNumber {
  double value;              ///< NaN if there is a `problem`
  char decimal_mark = '\0';  ///< '.' or ',' if present
  std::string_view problem;  ///< reason, such as "is not a number"
};

/// Decimal and thousands marks of a file, found in the cells.
struct DecimalMarks {
  char decimal = '\0';    ///< decimal mark; '\0': not known
  char thousands = '\0';  ///< mark between groups of three digits; '\0': no mark
  char asked = '\0';      ///< mark that may be decimal or thousands mark; '\0': none
};

/// A column of a table that does not come from a file.
struct DataColumn {
  std::string name;
  std::vector<double> numbers{};  ///< NaN where missing; empty for texts
  std::vector<std::string> texts{};
};

/// Function that finds header, row of units and separator (CsvForm) of a UTF-8 text.
using FormFinder = std::function<CsvForm(std::string_view)>;

/// Contents of a delimited text file: names of columns, and cells with their line numbers.
///
/// The separator is a comma, a semicolon or a tab, as found in the header, or the separator of the
/// CsvForm. Lines that begin with `#` are comments, with two exceptions. The last comment above the
/// data is the header if its cells fit the first row. A line below the header that begins with `#`
/// is a row if its cells fit the header ("#N/A,20,0.1"). Blank lines, rows of empty cells, repeated
/// headers, and text or statistics ("mean", "max") after the last row are skipped. A cell may be
/// quoted ("a ""b"""), but a quoted cell must end on the same line. If a file of another program
/// has a unit after every number of a column ("12.3 °C"), this unit becomes the unit of the column.
/// Blanks around cells are removed. An apostrophe that stops a spreadsheet from reading =, +, -
/// or @ as a formula is removed too (text/detail/csv_text.h).
/// Memory: the text plus 16 bytes per cell.
class CsvTable {
 public:
  std::string source;                 ///< file name, for messages
  std::vector<std::string> comments;  ///< all comment lines of the file, unchanged
  std::vector<std::string> header;
  std::vector<std::string> units;  ///< cells of the row of units; empty without such a row
  int header_line = 0;             ///< counted from 1
  char separator = ',';
  bool byte_order_mark = false;
  bool carriage_returns = false;   ///< true: lines end with CR or CR LF
  std::vector<std::string> notes;  ///< notes for the user, without the file's name

  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  [[nodiscard]] int line(std::size_t row) const { return lines_[row]; }
  /// Returns a cell of a text column. Call it only if is_numeric() is false.
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const {
    if (!columns_.empty()) return columns_[column].texts[row];
    const Cell& c = cells_[row * header.size() + column];
    return std::string_view(text_).substr(c.begin, c.size);
  }
  /// Returns true if the column was given as numbers and not as text.
  [[nodiscard]] bool is_numeric(std::size_t column) const {
    return !columns_.empty() && columns_[column].texts.empty();
  }
  /// Returns a cell as text for messages and names, for any type of column. The text is empty if a
  /// numeric cell is NaN.
  [[nodiscard]] std::string shown(std::size_t row, std::size_t column) const;
  [[nodiscard]] bool is_empty(std::size_t row, std::size_t column) const;
  /// Returns the number in a cell, or the reason why there is none. Throws InputError for an
  /// ambiguous cell, such as 1.200 in a column with 600.
  [[nodiscard]] ParsedNumber parsed(std::size_t row, std::size_t column) const;
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
  /// Returns the place of the column `name` in the header, for error messages.
  [[nodiscard]] Place header_place(std::string_view name = {}) const {
    return {.file = source, .line = header_line, .key = std::string(name)};
  }
  /// Returns the number in a cell. Throws InputError with line and column if the cell is not a
  /// number.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
  /// Sets the decimal mark to point or comma. The other mark then separates thousands. Without this
  /// call, the table finds the decimal mark from its cells, and number() and parsed() throw
  /// InputError for ambiguous cells.
  void set_decimal_mark(char mark);
  /// Removes the rows that `remove` marks with true; `remove` has one value for each row.
  void remove_rows(const std::vector<bool>& remove);

 private:
  friend CsvTable parse_csv(std::string text, const std::string& source, bool byte_order_mark,
                            const FormFinder& find_form);
  struct Cell {
    std::size_t begin;
    std::size_t size;
  };
  friend CsvTable table_of_columns(std::string source, std::vector<DataColumn> columns);
  [[nodiscard]] ParsedNumber parsed_text(std::size_t row, std::size_t column,
                                         std::string_view text) const;
  /// Converts "12.3 °C" in all cells of a column to 12.3, and makes °C the unit of the column.
  void take_units_out_of_cells();
  std::string text_;
  std::vector<Cell> cells_;          // row by row
  std::vector<DataColumn> columns_;  // instead of text_ and cells_ for table_of_columns()
  std::vector<int> lines_;
  DecimalMarks marks_;
};

/// Creates a table from columns of numbers or texts. Row numbers in messages are the line numbers
/// of a CSV file with one header line. Throws InputError if there are no columns or no rows, if
/// columns have different lengths, if a column name is missing or occurs twice, or if a text has a
/// control character.
[[nodiscard]] CsvTable table_of_columns(std::string source, std::vector<DataColumn> columns);

/// Reads a file. Throws InputError in these cases: the file cannot be read; it has a control
/// character, no header, no rows or more than 10 000 columns; a column name other than the first is
/// missing; a name occurs twice; the number of cells or the separator of a row differs from the
/// header.
[[nodiscard]] CsvTable read_csv(const std::string& path, const FormFinder& find_form = {});

/// Parses a file from text, otherwise like read_csv(); `source` is the name in messages.
[[nodiscard]] CsvTable parse_csv(std::string text, const std::string& source,
                                 bool byte_order_mark = false, const FormFinder& find_form = {});

/// Reads a whole cell as a number, independent of the locale. The cell must contain only the
/// number: blanks, thousands separators, hexadecimal numbers, "nan" and "inf" are not allowed. A
/// comma is a decimal mark only if `decimal_comma` is true.
[[nodiscard]] ParsedNumber parse_number(std::string_view cell, bool decimal_comma);

/// Returns true if the points in these numbers can be thousands separators: each number with a
/// point has groups of three digits, such as "1.200", and each number without a point is a whole
/// number below 1000.
[[nodiscard]] bool may_have_thousands(std::span<const std::string_view> numbers);

/// Returns a cell for a message: in quotes, shortened to 40 characters.
[[nodiscard]] std::string quoted(std::string_view cell);

}  // namespace raceway::text
