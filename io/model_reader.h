#pragma once

#include <string>

#include "io/model_file.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

namespace raceway::io {

/// The model that these tables describe, `text` being that of its file; throws as read_model().
/// Shared by the readers of models, not for other code.
[[nodiscard]] ModelFile model_of_tables(ModelTables& tables, std::string text);

}  // namespace raceway::io
