#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/column_map.h"
#include "text/csv.h"

/// Columns of a record over time from another program, as a table [columns].
namespace raceway::files {

struct SeriesColumns {
  std::string text;       ///< [columns] as TOML
  bool all_ours = false;  ///< true: the file uses the names of raceway and needs no table
};

/// Works like suggested_columns(): first the columns that these models need, then all other columns
/// of a record over time. Columns in `given` are kept.
[[nodiscard]] SeriesColumns series_columns(const text::CsvTable& table,
                                           const std::vector<correction::Model>& models,
                                           const ColumnMap& given);

}  // namespace raceway::files
