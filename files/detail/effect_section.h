#pragma once

#include <vector>

#include "effects/effect.h"
#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// The tables [[effect]] of a model file; shared with the reader of models.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> effect_tables();

/// `shaft` is null for a bearing on a rig; `spindle`: reads the effects of a spindle. Throws
/// InputError as read_model() does.
[[nodiscard]] std::vector<effects::Effect> read_effects(ModelTables& tables,
                                                        const model::Shaft* shaft,
                                                        bool spindle = false);

}  // namespace raceway::files
