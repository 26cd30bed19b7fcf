#pragma once

#include <vector>

#include "effects/effect.h"
#include "model/model.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// The tables [[effect]] of a model file; shared with the reader of models, not for other code.
namespace raceway::io {

[[nodiscard]] std::vector<KeyTable> effect_tables();

/// `shaft` is null for a bearing on a rig; of a spindle, effects are those of a spindle. Throws
/// InputError as read_model() does.
[[nodiscard]] std::vector<effects::Effect> read_effects(ModelTables& tables,
                                                        const model::Shaft* shaft,
                                                        bool spindle = false);

}  // namespace raceway::io
