#pragma once

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reader of [bearing] with type = "cylindrical-roller" of a model file; shared with the reader of
/// models. All functions throw InputError like read_model().
namespace raceway::files {

/// Returns the key `type` of [bearing], which ball bearings and roller bearings share.
[[nodiscard]] std::span<const Key> keys_of_type();
[[nodiscard]] std::vector<KeyTable> roller_tables();

/// Returns true if [bearing] describes a bearing with cylindrical rollers.
[[nodiscard]] bool has_rollers(const ModelTables& tables);

/// Checks `type` in the table of a ball bearing. Throws InputError for keys of roller bearings.
void refuse_keys_of_rollers(const Section& bearing);

/// Returns the required keys of a roller bearing that are missing in [bearing].
[[nodiscard]] Names missing_keys_of_rollers(const ModelTables& tables);

/// Reads [[shaft.roller_bearing]] of a spindle.
[[nodiscard]] std::vector<model::RollerOnShaft> read_rollers_on_shaft(ModelTables& tables);

/// Reads the model of a bearing with cylindrical rollers on a rig from the tables of the bearing
/// and its rig. The general reader reads calibration, tolerances and records.
[[nodiscard]] model::Model read_roller_model(ModelTables& tables);

}  // namespace raceway::files
