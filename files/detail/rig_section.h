#pragma once

#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the tables [rig] and [solver] of a model file. All functions throw InputError like
/// read_model(). The tables may also contain the keys `further`.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> rig_tables();

[[nodiscard]] model::Rig read_rig(ModelTables& tables, Keys further);

/// Reads `tilt` in [solver], the only key of [solver] for a cylindrical roller bearing.
[[nodiscard]] bearing::Tilt read_tilt(ModelTables& tables);

/// Contents of [solver]. If `balanced_balls` is true, no race control is assumed. Only the contact
/// law allows this.
struct SolverOfFile {
  bearing::EquilibriumOptions options;
  bool balanced_balls = false;
};
[[nodiscard]] SolverOfFile read_solver(ModelTables& tables, friction::FrictionLaw law,
                                       Keys further);

}  // namespace raceway::files
