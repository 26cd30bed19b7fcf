#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "friction/stribeck_table.h"
#include "text/csv.h"

namespace raceway::files {

/// Speeds, axial loads, radial loads and temperatures of the rows of a table [SI].
using TableInputs = std::array<std::vector<double>, 4>;

/// Throws InputError if the file is only one slab of a table.
void refuse_slab(const text::CsvTable& csv);

/// Fills in the axes of a table and returns the point of each row. Throws InputError for invalid
/// axes, repeated points, and rows that do not form a complete grid.
[[nodiscard]] std::vector<std::size_t> points_of_rows(const text::CsvTable& csv,
                                                      const TableInputs& inputs,
                                                      friction::StribeckTable& table);

}  // namespace raceway::files
