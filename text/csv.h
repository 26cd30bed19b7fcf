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

/// Form of a delimited text file: position of the header, position of the row of units, and
/// separator.
struct CsvForm {
  int header_line = 0;    ///< line number of the header; lines above it are skipped; 0: first line
  int unit_line = 0;      ///< line number of the row of units below the header; 0: no such row
  char separator = '\0';  ///< '\0': the parser finds the separator
};

/// A number, or the reason why a cell is not a number.
struct ParsedNumber {
  double value;              ///< NaN if the cell is not a number
  char decimal_mark = '\0';  ///< '.' or ','; '\0': the number has no decimal mark
  std::string_view problem;  ///< reason, such as "is not a number"; empty for a number
};

/// Decimal and thousands marks of a file, found in the cells.
struct DecimalMarks {
  char decimal = '\0';    ///< decimal mark; '\0': not known
  char thousands = '\0';  ///< mark between groups of three digits; '\0': no mark
  char asked = '\0';      ///< mark that may be a decimal or a thousands mark; '\0': none
};

/// Data of a column that does not come from a file: either numbers or texts.
struct DataColumn {
  std::string name;
  std::vector<double> numbers{};  ///< NaN for a missing number; empty for a column of texts
  std::vector<std::string> texts{};
};

/// Function that finds header, row of units and separator (CsvForm) of a UTF-8 text.
using FormFinder = std::function<CsvForm(std::string_view)>;

/// Table from a delimited text file: names of columns, and cells with their line numbers.
///
/// The separator is a comma, a semicolon or a tab, as found in the header, unless CsvForm gives
/// another separator. Lines that begin with `#` are comments, with two exceptions. The last comment
/// line above the data is the header if it has a name for each cell of the first row. A line with
/// `#` below the header is a row if it has a cell for each name in the header ("#N/A,20,0.1").
/// Blank lines, rows of empty cells, repeated headers, and text or statistics ("mean", "max") after
/// the last row are skipped.
///
/// A cell may be quoted ("a ""b"""), but a quoted cell must end on the same line. Blanks around
/// cells are removed. If all numbers of a column have the same unit behind them ("12.3 °C"), this
/// unit becomes the unit of the column. Some programs, including raceway, write an apostrophe
/// before a text that begins with =, +, - or @, so that a spreadsheet does not read the text as a
/// formula. This apostrophe is removed.
///
/// Memory: the size of the text plus 16 bytes for each cell.
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
  /// Returns a cell of a text column. Call this function only if is_numeric() is false.
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const {
    if (!columns_.empty()) return columns_[column].texts[row];
    const Cell& c = cells_[row * header.size() + column];
    return std::string_view(text_).substr(c.begin, c.size);
  }
  /// Returns true for a column of numbers from table_of_columns(), and false for a column of texts.
  [[nodiscard]] bool is_numeric(std::size_t column) const {
    return !columns_.empty() && columns_[column].texts.empty();
  }
  /// Returns a cell as text for messages and names, for any type of column. The text is empty if a
  /// numeric cell is NaN.
  [[nodiscard]] std::string shown(std::size_t row, std::size_t column) const;
  [[nodiscard]] bool is_empty(std::size_t row, std::size_t column) const;
  /// Returns the number in a cell, or the reason why there is none. Throws InputError for an
  /// ambiguous cell, such as "1.200" (1.2 or 1200) in a column with the number 600.
  [[nodiscard]] ParsedNumber parsed(std::size_t row, std::size_t column) const;
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
  /// Returns the place of the column `name` in the header, for error messages.
  [[nodiscard]] Place header_place(std::string_view name = {}) const {
    return {.file = source, .line = header_line, .key = std::string(name)};
  }
  /// Returns the number in a cell. Throws InputError with line and column if the cell is not a
  /// number.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
  /// Sets the decimal mark to point or comma. With a decimal comma, a point separates thousands,
  /// and vice versa. Without this call, the table finds the decimal mark from its cells, and
  /// number() and parsed() throw InputError for ambiguous cells.
  void set_decimal_mark(char mark);
  /// Removes all rows for which `remove` is true. `remove` has one value for each row.
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

/// Creates a table from columns of numbers or texts. Messages give a line number for each row as in
/// a CSV file with one header line, so the first row is line 2. Throws InputError if there are no
/// columns or no rows, if columns have different lengths, if a column name is missing or occurs
/// twice, or if a text has a control character.
[[nodiscard]] CsvTable table_of_columns(std::string source, std::vector<DataColumn> columns);

/// Reads a file. Throws InputError in these cases:
///   - The file cannot be read, or contains a control character.
///   - The file has no header, no rows or more than 10 000 columns.
///   - A column name is missing (except for the first column) or occurs twice.
///   - A row has another number of cells or another separator than the header.
[[nodiscard]] CsvTable read_csv(const std::string& path, const FormFinder& find_form = {});

/// Parses a text in the same way as read_csv() parses a file. `source` is the file name in
/// messages.
[[nodiscard]] CsvTable parse_csv(std::string text, const std::string& source,
                                 bool byte_order_mark = false, const FormFinder& find_form = {});

/// Reads a cell as a number, independent of the locale. The whole cell must be a decimal number.
/// Blanks, thousands separators, hexadecimal numbers, "nan" and "inf" are not allowed. A comma is a
/// decimal mark only if `decimal_comma` is true.
[[nodiscard]] ParsedNumber parse_number(std::string_view cell, bool decimal_comma);

/// Returns true if the points in these numbers can be thousands separators: each number with a
/// point has groups of three digits, such as "1.200", and each number without a point is a whole
/// number below 1000.
[[nodiscard]] bool may_have_thousands(std::span<const std::string_view> numbers);

/// Returns the text of a cell for a message: in quotes, and shortened to 40 characters.
[[nodiscard]] std::string quoted(std::string_view cell);

}  // namespace raceway::text
