#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/number_text.h"

namespace raceway::cli {

/// Table for the terminal: right-aligned columns of text below a header and a line of units.
/// Columns that do not fit the width follow in further blocks. Each block repeats the first column.
class TextTable {
 public:
  struct Column {
    std::string name;
    std::string unit;
    bool left = false;   ///< true: the cells are left-aligned, as for words
    bool wraps = false;  ///< true: long text in the last column is broken into lines
  };
  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::string text(std::size_t width) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  /// Breaks the text of the last column into lines, so that the table fits `width`. Each line is a
  /// separate row.
  [[nodiscard]] TextTable wrapped(std::size_t width) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Breaks text into lines of at most `width` characters. Only a word that is longer than `width`
/// gives a longer line.
[[nodiscard]] std::vector<std::string> filled(std::string_view words, std::size_t width);

using text::number;

/// Returns `value` as text. The text has as many decimals as the text of `scale` from number(), so
/// that a reader can compare both numbers. A value that is rounded to zero has no minus sign. If
/// `sign` is true, a positive value begins with +.
[[nodiscard]] std::string beside(double value, double scale, int digits, bool sign);

/// Returns the number of columns of the terminal on stdout or on another stream; 80 if the stream
/// is not a terminal.
[[nodiscard]] std::size_t terminal_width(int stream = 1);

}  // namespace raceway::cli
