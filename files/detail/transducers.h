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

/// Replaces the transducers by the displacements that they give, and reports it. A reading with a
/// missing transducer is missing. A record without any transducer is unchanged.
void combine_transducers(record::Record& record, const ColumnMap& map,
                         const std::vector<const record::Channel*>& wanted);

/// The table [transducers] of a model file; empty without combinations.
[[nodiscard]] std::string transducers_text(const ColumnMap& map);

}  // namespace raceway::files
