#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "text/csv.h"

/// Columns of another program's file that may match our columns; shared by the functions that
/// propose them.
namespace raceway::files {

struct ColumnProposal {
  const record::Channel* channel;
  std::size_t column;
  const text::Unit* unit = nullptr;  ///< null if not found
  /// As the file states it; empty where it states none, or a known one.
  std::string unknown_unit{};
  bool excel_date = false, stamped = false;
  bool has_our_name = false;  ///< the file needs no rule for it
  std::string remark{};       ///< for people, behind its line
  std::size_t score = 0;
};

/// Converts text to small letters, everything between words to "_", without the unit.
[[nodiscard]] std::string plain_name(std::string_view header);

/// Letters of the longest of these words, which blanks separate, that is in the name; 0 for none. A
/// word of one or two letters must stand alone.
[[nodiscard]] std::size_t longest_word_in(std::string_view name, std::string_view words);

/// Returns the numbers of a column, without cells that are not numbers.
[[nodiscard]] std::vector<double> numbers_in(const text::CsvTable& table, std::size_t column);

/// The column as the channel, with its unit; its score is 20 where that is stated, 10 for dates, 1
/// for the letter by which t is a time and T a temperature.
/// Nothing where the channel cannot be in it: a unit of another kind, texts, times that do not
/// rise, temperatures that no machine has.
[[nodiscard]] std::optional<ColumnProposal> column_as(const text::CsvTable& table,
                                                      std::size_t column,
                                                      const record::Channel& channel);

/// A table [columns] of the rules of `given`, then these proposals, then `missing` lines, then the
/// columns that are not used.
[[nodiscard]] std::string proposed_columns(const text::CsvTable& table,
                                           const std::vector<ColumnProposal>& proposals,
                                           const std::vector<std::string>& missing,
                                           const ColumnMap& given = {});

}  // namespace raceway::files
