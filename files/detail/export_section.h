#pragma once

#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reader of [export] of a model file; shared with the reader of corrections.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> export_tables();

/// Reads [export], or returns the defaults without this table. Throws InputError like
/// read_correction(), and for a column that no model has.
[[nodiscard]] correction::ControlSettings read_export(const ModelTables& tables,
                                                      const std::vector<correction::Model>& models);

}  // namespace raceway::files
