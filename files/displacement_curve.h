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

/// Reads `speed_rpm`, `axial_displacement_um` and, where it is given, `std_um` of a CSV, as
/// `raceway displacement` writes it or a rig does; "-" is standard input. Other columns are not
/// read, and `notes` says so. So are rows without displacement whose column `status` tells why.
///
/// Throws InputError as read_csv(), for a missing column, and for every other cell that is empty,
/// no number or impossible (all of them in one message).
[[nodiscard]] DisplacementCurve read_displacement_curve(const Source& source,
                                                        const ReadOptions& options = {});

/// A table as CSV: speed_rpm, axial_displacement_um, slope_um_rpm, with how to interpolate.
/// `source` is the curve that it was made from.
[[nodiscard]] std::string displacement_table_text(const shaft::DisplacementTable& table,
                                                  std::string_view source);

}  // namespace raceway::files
