#pragma once

#include <string>
#include <vector>

#include "record/record.h"
#include "text/bad_cells.h"

/// Shared by the readers of records over time.
namespace raceway::files {

/// Fills the rows in which an input was not read, within its run: sensors have rates of their own,
/// and some programs write a value when it changes. What a control sets holds until its next value.
/// A temperature goes in a straight line from one reading to the next, up to 10 times the usual
/// time between its readings, or 5 minutes where that is more; at the ends of a run the nearest
/// reading holds for as long. Rows that stay empty, in longer gaps or before the first value, go to
/// `bad`. Returns a line on what was filled, empty for nothing.
[[nodiscard]] std::string fill_input(const record::Channel& channel, record::Record& data,
                                     text::BadCells& bad);

}  // namespace raceway::files
