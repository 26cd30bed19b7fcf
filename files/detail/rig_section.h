#pragma once

#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Readers of [rig] and [solver] of a model file; shared with the reader of models. All functions
/// throw InputError like read_model(). The keys `further` are allowed.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> rig_tables();

[[nodiscard]] model::Rig read_rig(ModelTables& tables, Keys further);

/// Reads `tilt` of [solver], which is the only key of [solver] for a bearing with cylindrical
/// rollers.
[[nodiscard]] bearing::Tilt read_tilt(ModelTables& tables);

/// Contents of [solver]. `balanced_balls`: no race controls the balls; only for the contact law.
struct SolverOfFile {
  bearing::EquilibriumOptions options;
  bool balanced_balls = false;
};
[[nodiscard]] SolverOfFile read_solver(ModelTables& tables, friction::FrictionLaw law,
                                       Keys further);

}  // namespace raceway::files
