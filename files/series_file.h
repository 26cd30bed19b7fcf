#pragma once

#include <string>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a record over time (columns with their units: docs/files.md) into SI: time_s or dates,
/// inputs of the machine, and displacements. Other columns are reported and ignored.
///
/// An empty cell in a displacement means no reading. Inputs are filled between their readings
/// (files/detail/filled_inputs.h). Of the displacements `wanted` are kept; all where that is empty.
///
/// Throws InputError: time_s missing, going back or standing still within a run; a column of
/// `needed` missing; a column that looks misspelt; cells that are empty, no numbers or impossible,
/// all in one message.
[[nodiscard]] record::Record read_series(const Source& source,
                                         const std::vector<const record::Channel*>& wanted,
                                         const std::vector<const record::Channel*>& needed,
                                         const ReadOptions& options = {});

/// Options for columns as read_series() reads them.
[[nodiscard]] ReadOptions over_time(ReadOptions options);

}  // namespace raceway::files
