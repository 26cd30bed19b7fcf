#pragma once

#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// [export] of a model file; shared with the reader of corrections.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> export_tables();

/// The defaults where it is not there. Throws InputError as read_correction() does, also where it
/// names a column that no model has.
[[nodiscard]] correction::ControlSettings read_export(const ModelTables& tables,
                                                      const std::vector<correction::Model>& models);

}  // namespace raceway::files
