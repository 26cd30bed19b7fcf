#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "friction/stribeck_table.h"

namespace raceway::files {

/// A Stribeck table read from its file.
struct TableFile {
  friction::StribeckTable table;
  std::string source;      ///< file name, for messages
  std::string model_text;  ///< TOML of its model; empty if the file has none
};

/// A Stribeck table as CSV: `#` lines with title, version and the model's text (each line behind
/// `#| `), then speed_rpm, axial_load_N, radial_load_N, temperature_C, friction_torque_Nmm, the
/// table's columns and the status. Points without value have empty cells. A slab says so in a
/// `#` line, with the number of points and a fingerprint of the whole grid.
///
/// The further columns change from SI to the unit at the end of their names (_Nmm, _deg, _um, ...;
/// without one they are dimensionless). Accuracy: 12 digits. Rows are written by all threads, and
/// their number changes no byte; `progress` is told the share that is done, by one thread at a
/// time.
[[nodiscard]] std::string table_text(const friction::StribeckTable& table, std::string_view title,
                                     std::string_view model_text,
                                     const std::function<void(double)>& progress = {});

/// Reads what table_text() wrote; the order of rows does not matter. Throws InputError as
/// read_csv(), for cells that are no numbers, and for points of the grid that are missing or stand
/// twice, and for a slab.
[[nodiscard]] TableFile read_table(const std::string& path);

/// A named file to be joined.
struct SlabText {
  std::string name;  ///< for messages
  std::string text;
};

/// Joins slabs to their table, byte for byte the result of table_text() for the whole. Throws
/// InputError for a file that is no slab, slabs of different tables (model, version, grid or
/// columns), one that is missing or comes twice, and rows that are too few or too many.
[[nodiscard]] std::string merged_table_text(const std::vector<SlabText>& slabs);

/// Parses a table from text; `source` is the name in messages.
[[nodiscard]] TableFile parse_table(std::string text, const std::string& source);

}  // namespace raceway::files
