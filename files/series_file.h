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
/// its other values, as far as possible (files/detail/filled_inputs.h). If cells of an input remain
/// empty, these rows or the whole column are not used, and a note says so. Only the displacements
/// in `wanted` are kept; all of them if `wanted` is empty.
///
/// Throws InputError if time_s is missing or does not rise within a run, if a column of `needed` is
/// missing, if a column name looks misspelt, for an empty cell of another column, such as time_s,
/// and for cells that are not numbers or outside the allowed range. One message shows the first ten
/// invalid cells and counts the others.
[[nodiscard]] record::Record read_series(const Source& source,
                                         const std::vector<const record::Channel*>& wanted,
                                         const std::vector<const record::Channel*>& needed,
                                         const ReadOptions& options = {});

/// Returns the options with `over_time` = true, as read_series() needs them.
[[nodiscard]] ReadOptions over_time(ReadOptions options);

}  // namespace raceway::files
