#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "text/csv.h"

/// Proposal to read a column of another program's file as a quantity of raceway.
namespace raceway::files {

struct ColumnProposal {
  const record::Channel* channel;
  std::size_t column;
  const text::Unit* unit = nullptr;  ///< unit of the column; null if not found
  /// Unit in the file, if raceway does not know it; otherwise empty.
  std::string unknown_unit{};
  bool excel_date = false, stamped = false;
  bool has_our_name = false;  ///< true: the column has a name of raceway and needs no rule
  std::string remark{};       ///< comment after the rule in [columns]
  std::size_t score = 0;
};

/// Returns a column header without its unit, in lower case, with "_" between words.
[[nodiscard]] std::string plain_name(std::string_view header);

/// Returns the number of letters of the longest word in `words` that the name contains; 0 if it
/// contains none. Blanks separate `words`. A word of one or two letters must be a separate word of
/// the name.
[[nodiscard]] std::size_t longest_word_in(std::string_view name, std::string_view words);

/// Returns the numbers of a column, without cells that are not numbers.
[[nodiscard]] std::vector<double> numbers_in(const text::CsvTable& table, std::size_t column);

/// Returns a proposal to read the column as this channel, with the unit of the column. The score is
/// a sum: 20 if the file states a unit of the channel, 10 for dates, and 1 for the header t of a
/// time or T of a temperature. Returns nothing if the column cannot be this channel: a unit of
/// another dimension, texts, times that do not rise, or temperatures that no machine has.
[[nodiscard]] std::optional<ColumnProposal> column_as(const text::CsvTable& table,
                                                      std::size_t column,
                                                      const record::Channel& channel);

/// A file and the proposals for its columns.
struct ProposedFile {
  const text::CsvTable* table;
  std::vector<ColumnProposal> proposals;
};

/// Returns the text of a table [columns]: the rules of `given`, a rule for each proposal, the lines
/// `missing`, and comments with the unused columns. If columns of several files give the same
/// quantity, as the time, the rule is a list of these columns.
[[nodiscard]] std::string proposed_columns(const std::vector<ProposedFile>& files,
                                           const std::vector<std::string>& missing,
                                           const ColumnMap& given = {});

}  // namespace raceway::files
