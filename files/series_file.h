#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a time record and converts it to SI: time_s or dates, inputs of the machine, and
/// displacements. docs/files.md lists the columns with their units. Other columns are not used in
/// calculations, and a note lists them.
///
/// An empty cell of a displacement is a missing reading. Empty cells of an input are filled from
/// the other values of the input, as far as possible. If cells of an input remain empty, the rows
/// of these cells or the whole column are not used, and a note says so. Only the displacements in
/// `wanted` are kept; if `wanted` is empty, all displacements are kept.
///
/// Throws InputError if time_s is missing or does not rise within a run, if a column of `needed` is
/// missing, if a column name looks misspelt, and for invalid cells. A cell is invalid if it is not
/// a number or is outside the allowed range. An empty cell is invalid in a column that is neither a
/// displacement nor an input, such as time_s. The message shows the first ten invalid cells and
/// gives the number of all invalid cells.
[[nodiscard]] record::Record read_series(const Source& source,
                                         const std::vector<const record::Channel*>& wanted,
                                         const std::vector<const record::Channel*>& needed,
                                         const ReadOptions& options = {});

/// Returns the options with `over_time` = true, as read_series() needs them.
[[nodiscard]] ReadOptions over_time(ReadOptions options);

}  // namespace raceway::files
