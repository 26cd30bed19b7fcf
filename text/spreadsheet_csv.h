#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

/// Marks that a spreadsheet expects; defaults of a German Excel.
struct SpreadsheetMarks {
  char separator = ';';
  char decimal = ',';
};

struct SpreadsheetCsv {
  std::string table;     ///< the header is its first line
  std::string comments;  ///< all that stood behind `#`, with the model; empty for none
};

/// A CSV of this program as a spreadsheet opens it by a double click: with a byte order mark of
/// UTF-8, CR LF, the marks of the language, and without comments, which stand apart. Throws
/// std::invalid_argument where both marks are the same.
[[nodiscard]] SpreadsheetCsv spreadsheet_csv(std::string_view csv, SpreadsheetMarks marks = {});

}  // namespace raceway::text
