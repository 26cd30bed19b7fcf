#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "friction/stribeck_table.h"
#include "text/csv.h"

namespace raceway::files {

/// Speeds, axial loads, radial loads and temperatures of all rows of a table [SI].
using TableInputs = std::array<std::vector<double>, 4>;

/// Throws InputError if the file is one slab of a larger table: see table_text().
void refuse_slab(const text::CsvTable& csv);

/// Sets the axes of `table` from the rows and returns the index of the grid point for each row.
/// Throws InputError for invalid axes, for a point that occurs twice, and for rows that do not form
/// a complete grid.
[[nodiscard]] std::vector<std::size_t> points_of_rows(const text::CsvTable& csv,
                                                      const TableInputs& inputs,
                                                      friction::StribeckTable& table);

}  // namespace raceway::files
