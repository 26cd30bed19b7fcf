#pragma once

#include <string>
#include <vector>

#include "cli/csv_style.h"
#include "friction/stribeck_table.h"
#include "text/output_file.h"

namespace raceway::cli {

/// Parses the part of a table in `--slab i/N`: "2/4" is the second of four. Throws
/// text::InputError.
[[nodiscard]] friction::TableSlab slab_of(const std::string& text);

/// Joins the files of `table --slab` to the table of a single run, for `table --merge`.
void merge_slabs(const std::vector<std::string>& slabs, const std::string& output,
                 const CsvStyle& csv, text::IfExists if_exists);

}  // namespace raceway::cli
