#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"
#include "shaft/displacement_table.h"

namespace raceway::files {

/// Axial displacement over speed, read from a file.
struct DisplacementCurve {
  std::string source;  ///< file name, for messages
  std::vector<shaft::DisplacementPoint> points = {};
  std::vector<record::Note> notes;  ///< notes for the user
};

/// Reads `speed_rpm`, `axial_displacement_um` and, if present, `std_um` from a CSV file of `raceway
/// displacement` or of a rig; "-" is standard input. Other columns are ignored. A row without a
/// displacement is ignored if the file has a column `status` and the text in this column is not
/// "converged". `notes` lists the ignored columns and rows.
///
/// Throws InputError like read_csv(), and if `speed_rpm` or `axial_displacement_um` is missing.
/// Also throws InputError if a cell of a used row is empty, not a number or outside the allowed
/// range. The message shows the first ten invalid cells and gives the number of all invalid cells.
[[nodiscard]] DisplacementCurve read_displacement_curve(const Source& source,
                                                        const ReadOptions& options = {});

/// Returns a table as CSV text with the columns speed_rpm, axial_displacement_um and slope_um_rpm.
/// A comment line in the text states the interpolation rule. `source` is the name of the original
/// curve.
[[nodiscard]] std::string displacement_table_text(const shaft::DisplacementTable& table,
                                                  std::string_view source);

}  // namespace raceway::files
