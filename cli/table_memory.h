#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "friction/stribeck_table.h"

namespace raceway::cli {

/// Output form of a table.
enum class TableForm { text, file, json };

/// Throws text::InputError for a table with too many points for one run, or too large for the
/// memory: its size, and the number of slabs to use. Prints the size of a large table to stderr.
/// Call it before the calculation. `columns`: numbers per point.
void require_memory(const friction::TableAxes& axes, const friction::TableSlab& slab,
                    std::size_t columns, TableForm form);

/// Throws text::InputError if the slabs and their table do not fit into memory together.
void require_memory_to_merge(const std::vector<std::string>& files);

}  // namespace raceway::cli
