#pragma once

#include <vector>

#include "files/column_map.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> transducer_tables();

/// Returns the lines of the table [transducers]; empty without this table. Throws InputError for an
/// invalid combination, for a combination that depends linearly on earlier combinations, and for a
/// transducer whose factors are all 0.
[[nodiscard]] std::vector<Combination> read_transducers(const ModelTables& tables);

}  // namespace raceway::files
