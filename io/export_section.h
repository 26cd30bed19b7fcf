#pragma once

#include <vector>

#include "correction/model.h"
#include "io/control/settings.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [export] of a model file; shared with the reader of corrections, not for other code.
namespace raceway::io {

[[nodiscard]] std::vector<KeyTable> export_tables();

/// The defaults where it is not there. Throws InputError as read_correction() does, also where it
/// names a column that no model has.
[[nodiscard]] ControlSettings read_export(const ModelTables& tables,
                                          const std::vector<correction::Model>& models);

}  // namespace raceway::io
