#pragma once

#include "bearing/bearing_equilibrium.h"
#include "model/model.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [rig] and [solver] of a model file; shared with the reader of models, not for other code. Both
/// throw InputError as read_model() does. `further` keys are allowed.
namespace raceway::io {

[[nodiscard]] model::Rig read_rig(ModelTables& tables, const Names& further = {});

/// [solver], and whether a race holds the balls or, under the contact law alone, none.
struct SolverOfFile {
  bearing::EquilibriumOptions options;
  bool balanced_balls = false;
};
[[nodiscard]] SolverOfFile read_solver(ModelTables& tables, friction::FrictionLaw law,
                                       const Names& further = {});

}  // namespace raceway::io
