#pragma once

#include <vector>

#include "effects/effect.h"
#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the tables [[effect]] of a model file.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> effect_tables();

/// Returns the effects of the model. `shaft` is null for a bearing on a rig. `spindle`: true for
/// the model of a spindle. Throws InputError like read_model().
[[nodiscard]] std::vector<effects::Effect> read_effects(ModelTables& tables,
                                                        const model::Shaft* shaft,
                                                        bool spindle = false);

}  // namespace raceway::files
