#pragma once

#include <string>
#include <vector>

#include "cli/csv_style.h"
#include "friction/stribeck_table.h"
#include "text/output_file.h"

namespace raceway::cli {

/// Parses the value of `--slab i/N`: "2/4" is the second of four parts of a table. Throws
/// text::InputError for any other text.
[[nodiscard]] friction::TableSlab slab_of(const std::string& text);

/// Joins the files of `table --slab` to one table, for `table --merge`. The result equals the table
/// that the command writes without `--slab`.
void merge_slabs(const std::vector<std::string>& slabs, const std::string& output,
                 const CsvStyle& csv, text::IfExists if_exists);

}  // namespace raceway::cli
