#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "text/csv.h"

/// Columns of a measurement file that a record keeps although no model uses them.
namespace raceway::files {

struct KeptColumns {
  std::vector<record::Column> columns{};  ///< columns of numbers, NaN where missing
  std::vector<std::string> texts{};       ///< headers of text columns
  /// Returns a sentence such as "column A is unknown: kept, and not used" for each of these
  /// columns.
  [[nodiscard]] std::vector<std::string> statements(bool named_by_user) const;
};

/// Returns the columns with these headers, in the unit that the header or the row of units states.
[[nodiscard]] KeptColumns kept_columns(const text::CsvTable& table,
                                       const std::vector<std::string>& headers);

}  // namespace raceway::files
