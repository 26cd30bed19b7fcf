#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

/// Cell separator and decimal mark that a spreadsheet expects. The default values are for Excel
/// with German settings.
struct SpreadsheetMarks {
  char separator = ';';
  char decimal = ',';
};

/// CSV table whose first line is the header, and the comments that were removed from it.
struct PlainCsv {
  std::string table;
  std::string comments;  ///< text of all `#` lines, such as the model file; empty without `#` lines
};

/// Separates the table from the comments in a CSV text that this program has written.
[[nodiscard]] PlainCsv plain_csv(std::string_view csv);

/// Separates table and comments like plain_csv(), and converts the table so that a spreadsheet
/// opens it by a double click: with a UTF-8 byte order mark, CR LF as line ends, and the separator
/// and decimal mark in `marks`. Throws std::invalid_argument if separator and decimal mark are the
/// same.
[[nodiscard]] PlainCsv spreadsheet_csv(std::string_view csv, SpreadsheetMarks marks = {});

}  // namespace raceway::text
