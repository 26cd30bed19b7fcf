#pragma once

#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reads a table [bearing] with type = "cylindrical-roller" in a model file. All functions throw
/// InputError like read_model().
namespace raceway::files {

/// Returns the key `type` of [bearing], which ball bearings and roller bearings have.
[[nodiscard]] std::span<const Key> keys_of_type();
[[nodiscard]] std::vector<KeyTable> roller_tables();

/// Returns true if [bearing] describes a cylindrical roller bearing.
[[nodiscard]] bool has_rollers(const ModelTables& tables);

/// Checks `type` in the table of a ball bearing. Throws InputError if the table has keys of roller
/// bearings.
void refuse_keys_of_rollers(const Section& bearing);

/// Returns the required keys of a roller bearing that [bearing] lacks.
[[nodiscard]] Names missing_keys_of_rollers(const ModelTables& tables);

/// Returns the roller bearings in [[shaft.roller_bearing]] of a spindle.
[[nodiscard]] std::vector<model::RollerOnShaft> read_rollers_on_shaft(ModelTables& tables);

/// Returns the model of a cylindrical roller bearing on a rig, without the contents of
/// [calibration] and [loop], which loop_section.h reads.
[[nodiscard]] model::Model read_roller_model(ModelTables& tables);

}  // namespace raceway::files
