#pragma once

#include <memory>

#include "record/record.h"

namespace raceway::tolerance {

/// Returns a shorter copy of a long record, for faster fits: about 8000 means over equal time
/// intervals. Returns the record itself if it has at most 20 000 rows or no time, or if the copy
/// would have more than half of the rows of the record.
///
/// Each row of the result contains the means of time, readings and inputs over its original rows.
/// Rows without a reading do not contribute to the mean reading. For an input that is constant
/// between rows, such as a speed, the result contains the mean over time. The integral of this
/// input over time is therefore unchanged. The original rows of a mean belong to one run and one
/// clamping (setup_id).
///
/// Accuracy: good for lags whose time constants are much longer than the time between means (15 s
///           for a record of 34 h, 75 s for a week).
[[nodiscard]] std::shared_ptr<const record::Record> for_search(
    std::shared_ptr<const record::Record> record);

}  // namespace raceway::tolerance
