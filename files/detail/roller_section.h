#pragma once

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// [bearing] with type = "cylindrical-roller" of a model file; shared with the reader of models.
/// All throw InputError as read_model() does.
namespace raceway::files {

/// Key `type` of [bearing], for either kind.
[[nodiscard]] std::span<const Key> keys_of_type();
[[nodiscard]] std::vector<KeyTable> roller_tables();

/// True if [bearing] has cylindrical rollers.
[[nodiscard]] bool has_rollers(const ModelTables& tables);

/// Checks `type` in the table of a ball bearing and refuses keys of rollers there.
void refuse_keys_of_rollers(const Section& bearing);

/// Required keys of [bearing] with rollers that the file lacks.
[[nodiscard]] Names missing_keys_of_rollers(const ModelTables& tables);

/// Reads [[shaft.roller_bearing]] of a spindle.
[[nodiscard]] std::vector<model::RollerOnShaft> read_rollers_on_shaft(ModelTables& tables);

/// Reads the model of a bearing with cylindrical rollers on a rig from its own tables. The reader
/// of all models reads calibration, tolerances and records.
[[nodiscard]] model::Model read_roller_model(ModelTables& tables);

}  // namespace raceway::files
