#pragma once

#include "bearing/bearing_equilibrium.h"
#include "model/model.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [rig] and [solver] of a model file; shared with the reader of models, not for other code. Both
/// throw InputError as read_model() does. `further` keys are allowed.
namespace raceway::io {

[[nodiscard]] model::Rig read_rig(ModelTables& tables, const Names& further = {});
[[nodiscard]] bearing::EquilibriumOptions read_solver(ModelTables& tables,
                                                      const Names& further = {});

}  // namespace raceway::io
