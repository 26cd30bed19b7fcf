#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "friction/stribeck_table.h"

namespace raceway::cli {

/// Output form of a table.
enum class TableForm { text, file, json };

/// Throws text::InputError for a table with more points than can be made in one go, or that takes
/// more memory than there is: how much, and into how many slabs to cut it. Says on stderr what a
/// large one takes. Before anything is made. `columns`: how many numbers a point has.
void require_memory(const friction::TableAxes& axes, const friction::TableSlab& slab,
                    std::size_t columns, TableForm form);

/// Throws text::InputError where the slabs and their table do not fit into memory together.
void require_memory_to_merge(const std::vector<std::string>& files);

}  // namespace raceway::cli
