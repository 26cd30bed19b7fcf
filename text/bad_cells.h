#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "record/channel.h"
#include "text/csv.h"

namespace raceway::text {

/// Collects invalid cells for one error message. The message shows the first ten cells in the order
/// of their lines, and the number of all invalid cells.
class BadCells {
 public:
  /// `rows` is the number of rows of the table; the message shows it.
  BadCells(std::string source, std::size_t rows) : source_(std::move(source)), rows_(rows) {}

  void add(int line, std::string_view column, std::string_view cell, std::string_view problem);
  /// Throws InputError if invalid cells were collected.
  void throw_if_any() const;

 private:
  struct BadCell {
    int line;
    std::string column;
    std::string text;
  };
  static constexpr std::size_t shown = 10;
  std::string source_;
  std::size_t rows_;
  std::size_t count_ = 0;
  std::vector<BadCell> first_;  // by line
};

/// Allowed range of the cells of a column, in the unit of the column.
struct CellRange {
  std::string_view column;  ///< name of the column, for messages
  double lower, upper;      ///< limits of the closed range
  std::string_view unit;
};

/// Returns the allowed range of a channel, in the unit of the channel.
[[nodiscard]] inline CellRange range_of(const record::Channel& channel) {
  return {channel.name, channel.lower, channel.upper, channel.unit};
}

/// Reads a number from a cell, in the unit of the column. A cell that is not a number or is outside
/// `range` is added to `bad`.
[[nodiscard]] ParsedNumber read_cell(const CsvTable& table, std::size_t row, std::size_t column,
                                     const CellRange& range, BadCells& bad);

}  // namespace raceway::text
