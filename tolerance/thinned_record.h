#pragma once

#include <memory>

#include "record/record.h"

namespace raceway::tolerance {

/// Returns a shorter copy of a record for a search: about 8000 means over equal time intervals.
/// Returns the record itself if it has at most 20 000 rows or no time, or if the means would not
/// halve the number of rows. A search needs hundreds of simulations, whose cost grows with the
/// number of rows. At the end, the model that the search found is fitted to all rows.
///
/// Each row of the result is a mean at the mean time of its rows. An input that varies linearly is
/// exact at this time. For an input that is constant until the next row, the mean over time is
/// used, so lags respond to the same total input. A reading is the mean of the available readings.
/// The rows of a mean always belong to one run and one clamping (setup_id).
/// Accuracy: good for lags whose time constants are much longer than the spacing of the means (15 s
///           for a record of 34 h, 75 s for a week).
[[nodiscard]] std::shared_ptr<const record::Record> for_search(
    std::shared_ptr<const record::Record> record);

}  // namespace raceway::tolerance
