#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/column_map.h"
#include "text/csv.h"

/// Columns of a record over time that somebody else wrote, as a table [columns].
namespace raceway::files {

struct SeriesColumns {
  std::string text;       ///< [columns] as TOML
  bool all_ours = false;  ///< the file has our names and needs no table
};

/// As suggested_columns(): what these models ask for, then all else that a record over time can
/// have. Columns that `given` names are as it says.
[[nodiscard]] SeriesColumns series_columns(const text::CsvTable& table,
                                           const std::vector<correction::Model>& models,
                                           const ColumnMap& given);

}  // namespace raceway::files
