#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/column_map.h"
#include "text/csv.h"

/// Proposed table [columns] for a time record that another program wrote.
namespace raceway::files {

struct SeriesColumns {
  std::string text;       ///< text of the table [columns] (TOML)
  bool all_ours = false;  ///< true: the record uses the names of raceway and needs no table
};

/// Works like suggested_columns(): it finds first the columns that `models` need, then all other
/// columns. The rules in `given` are kept.
[[nodiscard]] SeriesColumns series_columns(const text::CsvTable& table,
                                           const std::vector<correction::Model>& models,
                                           const ColumnMap& given);

}  // namespace raceway::files
