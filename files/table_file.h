#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "friction/stribeck_table.h"

namespace raceway::files {

/// Contents of a file with a Stribeck table.
struct TableFile {
  friction::StribeckTable table;
  std::string source;      ///< file name, for messages
  std::string model_text;  ///< TOML text of the model; empty if the file has none
};

/// Returns a Stribeck table as CSV text: `#` lines with title, version and the text of the model
/// (each line after `#| `), then the columns speed_rpm, axial_load_N, radial_load_N, temperature_C,
/// friction_torque_Nmm, the other columns of the table, and status. Points without a value have
/// empty cells. A slab is a table of only some points of a grid. A `#` line of the slab gives its
/// number, the number of slabs, the numbers of points of slab and grid, and a fingerprint of the
/// grid.
///
/// The additional columns of a table are converted from SI to the unit at the end of their names
/// (_Nmm, _deg, _um, ...). A column without a unit is dimensionless. Numbers have 12 digits.
/// Several threads write rows, but the text is the same for any number of threads. Only one thread
/// at a time calls `progress`, with the finished fraction.
[[nodiscard]] std::string table_text(const friction::StribeckTable& table, std::string_view title,
                                     std::string_view model_text,
                                     const std::function<void(double)>& progress = {});

/// Reads a table written by table_text(). The rows may be in any order. Throws InputError like
/// read_csv(), for cells that are not numbers, for points of the grid that are missing or occur
/// twice, and for a slab.
[[nodiscard]] TableFile read_table(const std::string& path);

/// Text of a slab and its file name.
struct SlabText {
  std::string name;  ///< file name, for messages
  std::string text;
};

/// Joins the slabs of one table. The result equals the text of table_text() for the whole grid,
/// byte for byte. Throws InputError for a text that is not a slab, for slabs of tables with
/// different models, versions, grids or columns, for a slab that is missing or occurs twice, and
/// for too few or too many rows.
[[nodiscard]] std::string merged_table_text(const std::vector<SlabText>& slabs);

/// Parses a table from text; `source` is the file name in messages.
[[nodiscard]] TableFile parse_table(std::string text, const std::string& source);

}  // namespace raceway::files
