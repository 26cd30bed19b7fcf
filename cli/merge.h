#pragma once

#include <string>
#include <vector>

#include "cli/csv_style.h"
#include "friction/stribeck_table.h"
#include "text/output_file.h"

namespace raceway::cli {

/// Part of a table that `--slab i/N` asks for: "2/4" is the second of four. Throws
/// text::InputError.
[[nodiscard]] friction::TableSlab slab_of(const std::string& text);

/// Joins the files that `table --slab` wrote to the table made in one go, for `table --merge`.
void merge_slabs(const std::vector<std::string>& slabs, const std::string& output,
                 const CsvStyle& csv, text::IfExists if_exists);

}  // namespace raceway::cli
