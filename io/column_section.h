#pragma once

#include "io/column_map.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [columns] of a model file; shared with the reader of models, not for other code.
namespace raceway::io {

[[nodiscard]] std::vector<KeyTable> column_tables();

/// Empty where there is none. Throws InputError as read_model() does.
[[nodiscard]] ColumnMap read_columns(const ModelTables& tables);

}  // namespace raceway::io
