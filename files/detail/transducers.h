#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/column_map.h"
#include "record/record.h"

/// Combinations of transducers that give position and angle of a tool.
namespace raceway::files {

/// Returns the combinations of a map for the `wanted` displacements; all of them if `wanted` is
/// empty.
[[nodiscard]] std::vector<const Combination*> combinations_for(
    const ColumnMap& map, const std::vector<const record::Channel*>& wanted);

/// Replaces the readings of transducers by displacements, and adds a note on it. A displacement is
/// missing if a reading of one of its transducers is missing. A record without transducers is
/// unchanged.
void combine_transducers(record::Record& record, const ColumnMap& map,
                         const std::vector<const record::Channel*>& wanted);

/// Returns the table [transducers] of a model file; empty without combinations.
[[nodiscard]] std::string transducers_text(const ColumnMap& map);

}  // namespace raceway::files
