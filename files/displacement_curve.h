#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"
#include "shaft/displacement_table.h"

namespace raceway::files {

/// A displacement curve read from a file.
struct DisplacementCurve {
  std::string source;  ///< file name, for messages
  std::vector<shaft::DisplacementPoint> points = {};
  std::vector<record::Note> notes;  ///< notes for the user
};

/// Reads `speed_rpm`, `axial_displacement_um` and, if present, `std_um` from a CSV of `raceway
/// displacement` or of a rig; "-" is standard input. Other columns are not read. Rows without a
/// displacement are not read if the file has a column `status` that is not "converged" in these
/// rows. `notes` lists the columns and rows that were not read.
///
/// Throws InputError like read_csv(), for a missing column, and for every other cell of the read
/// columns that is empty, not a number or impossible. One message shows the first ten of these
/// cells and counts the others.
[[nodiscard]] DisplacementCurve read_displacement_curve(const Source& source,
                                                        const ReadOptions& options = {});

/// Returns a table as CSV: speed_rpm, axial_displacement_um, slope_um_rpm, with the rule of
/// interpolation in a comment. `source` is the curve from which the table was made.
[[nodiscard]] std::string displacement_table_text(const shaft::DisplacementTable& table,
                                                  std::string_view source);

}  // namespace raceway::files
