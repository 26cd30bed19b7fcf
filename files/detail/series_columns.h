#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/column_map.h"
#include "files/source.h"
#include "text/csv.h"

/// Proposed table [columns] for a time record that another program wrote.
namespace raceway::files {

struct SeriesColumns {
  std::string text;       ///< text of the table [columns] (TOML)
  bool all_ours = false;  ///< true: the record uses the names of raceway and needs no table
};

/// Works like suggested_columns(): it finds first the columns that `models` need, then all other
/// columns. `tables` are the files of one record. The rules in `given` are kept.
[[nodiscard]] SeriesColumns series_columns(const std::vector<text::CsvTable>& tables,
                                           const std::vector<correction::Model>& models,
                                           const ColumnMap& given);

/// Reads a file of a time record and the files beside it, for series_columns().
[[nodiscard]] std::vector<text::CsvTable> tables_of(const Source& source,
                                                    const ReadOptions& options);

}  // namespace raceway::files
