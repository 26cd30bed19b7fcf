#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

/// Marks that a spreadsheet expects; defaults of a German Excel.
struct SpreadsheetMarks {
  char separator = ';';
  char decimal = ',';
};

/// A table with its header in the first line.
struct PlainCsv {
  std::string table;
  std::string comments;  ///< all text after `#`, with the model; empty for none
};

/// Separates a CSV of this program from its comments.
[[nodiscard]] PlainCsv plain_csv(std::string_view csv);

/// Converts plain_csv() to a form that a spreadsheet opens by a double click: with a byte order
/// mark of UTF-8, CR LF and the marks of the language. Throws std::invalid_argument where both
/// marks are the same.
[[nodiscard]] PlainCsv spreadsheet_csv(std::string_view csv, SpreadsheetMarks marks = {});

}  // namespace raceway::text
