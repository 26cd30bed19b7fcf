#pragma once

#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the table [export] of a correction file.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> export_tables();

/// Returns the settings in [export]; the defaults if the file lacks this table. Throws InputError
/// like read_correction(), and for a column that no model uses.
[[nodiscard]] correction::ControlSettings read_export(const ModelTables& tables,
                                                      const std::vector<correction::Model>& models);

}  // namespace raceway::files
