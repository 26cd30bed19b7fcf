#pragma once

#include <string>

#include "files/model_file.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

namespace raceway::files {

/// Returns the model that these tables describe; `text` is the text of the model file. Throws the
/// same exceptions as read_model().
[[nodiscard]] ModelFile model_of_tables(ModelTables& tables, std::string text);

}  // namespace raceway::files
