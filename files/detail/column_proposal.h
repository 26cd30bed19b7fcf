#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "text/csv.h"

/// Columns in a file of another program that may match columns of raceway; shared by the functions
/// that propose columns.
namespace raceway::files {

struct ColumnProposal {
  const record::Channel* channel;
  std::size_t column;
  const text::Unit* unit = nullptr;  ///< null if not found
  /// Unit as the file states it, if it is unknown; otherwise empty.
  std::string unknown_unit{};
  bool excel_date = false, stamped = false;
  bool has_our_name = false;  ///< true: the column needs no rule
  std::string remark{};       ///< comment after the line
  std::size_t score = 0;
};

/// Returns a header without its unit, in lower case, with "_" between words.
[[nodiscard]] std::string plain_name(std::string_view header);

/// Returns the length of the longest of `words` that the name contains; 0 if it contains none.
/// Blanks separate the words. A word of one or two letters must be a separate word of the name.
[[nodiscard]] std::size_t longest_word_in(std::string_view name, std::string_view words);

/// Returns the numbers of a column, without cells that are not numbers.
[[nodiscard]] std::vector<double> numbers_in(const text::CsvTable& table, std::size_t column);

/// Returns a proposal to read the column as this channel, with the unit of the column. The score is
/// 20 for a stated unit, 10 for dates, and 1 for the letter t as a time or T as a temperature.
/// Returns nothing if the column cannot be the channel: a unit of another dimension, texts, times
/// that do not rise, temperatures that no machine has.
[[nodiscard]] std::optional<ColumnProposal> column_as(const text::CsvTable& table,
                                                      std::size_t column,
                                                      const record::Channel& channel);

/// Returns a table [columns]: the rules of `given`, these proposals, the lines of `missing`, and
/// the unused columns.
[[nodiscard]] std::string proposed_columns(const text::CsvTable& table,
                                           const std::vector<ColumnProposal>& proposals,
                                           const std::vector<std::string>& missing,
                                           const ColumnMap& given = {});

}  // namespace raceway::files
