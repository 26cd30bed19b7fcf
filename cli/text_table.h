#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/number_text.h"

namespace raceway::cli {

/// A plain table for people: columns of text, right-aligned, header and unit line on top. Columns
/// that do not fit the width are set below, behind the first column again.
class TextTable {
 public:
  struct Column {
    std::string name;
    std::string unit;
    bool left = false;   ///< left-aligned, for words
    bool wraps = false;  ///< for the last column: its words fill the remaining width
  };
  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::string text(std::size_t width) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  /// Breaks the last column into lines that fit `width`, each in a separate row.
  [[nodiscard]] TextTable wrapped(std::size_t width) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Breaks text into lines of at most `width` characters; only a longer word exceeds it.
[[nodiscard]] std::vector<std::string> filled(std::string_view words, std::size_t width);

using text::number;

/// Returns a value with as many decimals as number() gives `scale`, so that both can be compared;
/// never "-0.0". `sign` writes + before positive values.
[[nodiscard]] std::string beside(double value, double scale, int digits, bool sign);

/// Columns of the terminal on stdout, or on another stream; 80 where it is none.
[[nodiscard]] std::size_t terminal_width(int stream = 1);

}  // namespace raceway::cli
