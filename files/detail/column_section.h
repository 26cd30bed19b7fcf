#pragma once

#include "files/column_map.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the table [columns] of a model file.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> column_tables();

/// Reads [columns]; the result is empty without this table. Throws InputError like read_model().
[[nodiscard]] ColumnMap read_columns(const ModelTables& tables);

}  // namespace raceway::files
