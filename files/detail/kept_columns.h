#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "text/csv.h"

/// Columns of a measurement file that no model uses; shared by the readers of measurements.
namespace raceway::files {

struct KeptColumns {
  std::vector<record::Column> columns{};  ///< columns of numbers, NaN where missing
  std::vector<std::string> texts{};       ///< headers of text columns
  /// Returns "column A is unknown: kept, and not used" for each kept column.
  [[nodiscard]] std::vector<std::string> statements(bool named_by_user) const;
};

/// Returns the columns with these headers, in the unit stated by the header or the row of units.
[[nodiscard]] KeptColumns kept_columns(const text::CsvTable& table,
                                       const std::vector<std::string>& headers);

}  // namespace raceway::files
