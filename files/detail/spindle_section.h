#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reader of the tables that only the model file of a spindle has; shared with the reader of
/// models. All functions throw InputError like read_model().
namespace raceway::files {

/// Tables that only a spindle has.
[[nodiscard]] const Names& tables_of_spindle();

/// Returns true for the file of a spindle, which has either [shaft] and [housing], or [network].
/// Throws InputError for a file with only one of [shaft] and [housing], for [network] together with
/// the tables that it replaces, and for a file that has only other tables of a spindle.
[[nodiscard]] bool is_spindle(const ModelTables& tables);

/// Returns the keys of a spindle in tables that other models share; empty for other files.
[[nodiscard]] Keys spindle_keys(std::string_view table, bool spindle);

[[nodiscard]] std::vector<KeyTable> spindle_tables();

/// Reads a spindle, except bearings, lubricant and arrangement. Adds a note on each unusual but
/// possible value to `notes`.
[[nodiscard]] model::Spindle read_spindle(ModelTables& tables, const NamedBearing& bearing,
                                          const model::Shaft* shaft, Names& notes);

}  // namespace raceway::files
