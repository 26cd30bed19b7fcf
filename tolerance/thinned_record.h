#pragma once

#include <memory>

#include "record/record.h"

namespace raceway::tolerance {

/// Returns a shorter time record for a search: the record itself up to 20 000 rows, otherwise about
/// 8000 means over equal times. A search needs hundreds of simulations, whose cost grows with the
/// number of rows. Its result is finally fitted to all rows.
///
/// A mean is placed at the mean time of its rows. A linear input is exact there. An input that is
/// held until the next row has its mean over that time, so lags respond to the same total input.
/// Readings are the mean of the available readings. A mean never covers two runs or two clampings.
/// Accuracy: good for lags far slower than the spacing (15 s of 34 h, 75 s of a week).
[[nodiscard]] std::shared_ptr<const record::Record> for_search(
    std::shared_ptr<const record::Record> record);

}  // namespace raceway::tolerance
