#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "text/csv.h"

/// Columns of a file of measurements that no model asks for; shared by the readers of measurements.
namespace raceway::files {

struct KeptColumns {
  std::vector<record::Column> columns{};  ///< of numbers, NaN where there is none
  std::vector<std::string> texts{};       ///< headers of those that are none
  /// "column A is unknown: kept, and not used", for all of them.
  [[nodiscard]] std::vector<std::string> statements(bool named_by_user) const;
};

/// The columns under these headers, in the unit that their header or the row of units states.
[[nodiscard]] KeptColumns kept_columns(const text::CsvTable& table,
                                       const std::vector<std::string>& headers);

}  // namespace raceway::files
