#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

/// Marks that a spreadsheet expects; defaults of a German Excel.
struct SpreadsheetMarks {
  char separator = ';';
  char decimal = ',';
};

/// A table whose header is its first line.
struct PlainCsv {
  std::string table;
  std::string comments;  ///< all that stood behind `#`, with the model; empty for none
};

/// A CSV of this program without its comments, which stand apart.
[[nodiscard]] PlainCsv plain_csv(std::string_view csv);

/// plain_csv() as a spreadsheet opens it by a double click: with a byte order mark of
/// UTF-8, CR LF and the marks of the language. Throws std::invalid_argument where both marks are
/// the same.
[[nodiscard]] PlainCsv spreadsheet_csv(std::string_view csv, SpreadsheetMarks marks = {});

}  // namespace raceway::text
