#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "friction/stribeck_table.h"

namespace raceway::cli {

/// Output form of a table.
enum class TableForm { text, file, json };

/// Throws text::InputError if a table has too many points for one run or is too large for the
/// memory. The message gives the size of the table, and a suitable number of parts (slabs) for the
/// flag --slab. If the table needs more than 1 GB of memory, the function prints the needed memory
/// to stderr. Call this function before the calculation. `columns` is the number of values per
/// point.
void require_memory(const friction::TableAxes& axes, const friction::TableSlab& slab,
                    std::size_t columns, TableForm form);

/// Throws text::InputError if the memory is too small for the parts of a table (slabs) and the
/// joined table together.
void require_memory_to_merge(const std::vector<std::string>& files);

}  // namespace raceway::cli
