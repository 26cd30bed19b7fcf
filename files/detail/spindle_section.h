#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"

/// Reads the tables that only the model file of a spindle has. All functions throw InputError like
/// read_model().
namespace raceway::files {

/// Returns the names of the tables that only the model file of a spindle has.
[[nodiscard]] const Names& tables_of_spindle();

/// Returns true for the model file of a spindle, which has either [shaft] and [housing], or
/// [network]. Throws InputError for a file with only one of [shaft] and [housing], for [network]
/// together with tables that it replaces, and for a file with other tables of a spindle but none of
/// these three.
[[nodiscard]] bool is_spindle(const ModelTables& tables);

/// Returns the additional keys of a spindle in a table that other models also have; empty if
/// `spindle` is false.
[[nodiscard]] Keys spindle_keys(std::string_view table, bool spindle);

[[nodiscard]] std::vector<KeyTable> spindle_tables();

/// Returns the spindle, without its bearings, lubricant and arrangement. Adds a note to `notes` for
/// each possible but unusual value.
[[nodiscard]] model::Spindle read_spindle(ModelTables& tables, const NamedBearing& bearing,
                                          const model::Shaft* shaft, Names& notes);

}  // namespace raceway::files
