#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

/// Cell separator and decimal mark that a spreadsheet expects. The default values are for a German
/// Excel.
struct SpreadsheetMarks {
  char separator = ';';
  char decimal = ',';
};

/// A table with its header in the first line.
struct PlainCsv {
  std::string table;
  std::string comments;  ///< text of all `#` lines, including the model; empty if there are none
};

/// Separates the table in a CSV text of this program from the comments.
[[nodiscard]] PlainCsv plain_csv(std::string_view csv);

/// Separates table and comments like plain_csv(), and converts the table to a form that a
/// spreadsheet opens by a double click: with a UTF-8 byte order mark, CR LF and the given marks.
/// Throws std::invalid_argument if both marks are the same.
[[nodiscard]] PlainCsv spreadsheet_csv(std::string_view csv, SpreadsheetMarks marks = {});

}  // namespace raceway::text
