#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/column_map.h"
#include "record/record.h"

/// Calculates displacements and angles of a tool from the readings of transducers.
namespace raceway::files {

/// Returns the combinations in `map` for the displacements in `wanted`; all combinations if
/// `wanted` is empty.
[[nodiscard]] std::vector<const Combination*> combinations_for(
    const ColumnMap& map, const std::vector<const record::Channel*>& wanted);

/// Replaces the readings of transducers in a record by displacements, and adds a note about it. A
/// displacement is NaN in rows in which one of its transducers has no reading. A record without
/// transducers does not change.
void combine_transducers(record::Record& record, const ColumnMap& map,
                         const std::vector<const record::Channel*>& wanted);

/// Returns the text of the table [transducers] for a model file; empty if `map` has no
/// combinations.
[[nodiscard]] std::string transducers_text(const ColumnMap& map);

}  // namespace raceway::files
