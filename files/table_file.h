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

/// Returns a Stribeck table as CSV text. The text begins with `#` lines for the title, the version
/// of the program and the text of the model (each line of the model after `#| `). The columns are
/// speed_rpm, axial_load_N, radial_load_N, temperature_C, friction_torque_Nmm, the additional
/// columns of the table, and status. Points without a value have empty cells. If `table` is a slab,
/// one of several parts of a large table that are computed separately, a `#` line gives the number
/// of the slab and the grid of the whole table.
///
/// The additional columns of a table are converted from SI to the unit at the end of their names
/// (_Nmm, _deg, _um, ...). A column without a unit is dimensionless. Numbers have 12 digits. The
/// text does not depend on the number of threads. `progress` receives the finished fraction, from 0
/// to 1; its calls do not overlap.
[[nodiscard]] std::string table_text(const friction::StribeckTable& table, std::string_view title,
                                     std::string_view model_text,
                                     const std::function<void(double)>& progress = {});

/// Reads a table written by table_text(). The rows may be in any order. Throws InputError in the
/// same cases as read_csv(). Also throws InputError for cells that are not numbers, for points of
/// the grid that are missing or occur twice, and for a file that is only a slab of a table.
[[nodiscard]] TableFile read_table(const std::string& path);

/// Text of a slab and its file name.
struct SlabText {
  std::string name;  ///< file name, for messages
  std::string text;
};

/// Joins the slabs of one table. The result equals the text of table_text() for the whole grid,
/// byte for byte. Throws InputError if a text is not a slab, if the slabs have different models,
/// versions, grids or columns, if a slab is missing or occurs twice, and if a slab has too few or
/// too many rows.
[[nodiscard]] std::string merged_table_text(const std::vector<SlabText>& slabs);

/// Parses a table from text; `source` is the file name in messages.
[[nodiscard]] TableFile parse_table(std::string text, const std::string& source);

}  // namespace raceway::files
