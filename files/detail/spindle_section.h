#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Tables that only the model file of a spindle has; shared with the reader of models. All throw
/// InputError as read_model() does.
namespace raceway::files {

/// Tables that only a spindle has.
[[nodiscard]] const Names& tables_of_spindle();

/// Returns true for the file of a spindle: [shaft] and [housing], or [network]. Refuses a file that
/// has one of the two, both kinds, or another table of a spindle without them.
[[nodiscard]] bool is_spindle(const ModelTables& tables);

/// Returns the keys of a spindle in tables that other models share; empty for other files.
[[nodiscard]] Keys spindle_keys(std::string_view table, bool spindle);

[[nodiscard]] std::vector<KeyTable> spindle_tables();

/// Reads a spindle except bearings, lubricant and arrangement. `notes`: unusual but possible
/// values.
[[nodiscard]] model::Spindle read_spindle(ModelTables& tables, const NamedBearing& bearing,
                                          const model::Shaft* shaft, Names& notes);

}  // namespace raceway::files
