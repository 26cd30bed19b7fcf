#pragma once

#include <memory>

#include "record/record.h"

namespace raceway::tolerance {

/// A record over time with rows enough for a search: itself up to 20 000 rows, otherwise means over
/// equal times, some 8000 of them. A search asks for hundreds of simulations, each as long as the
/// record has rows; what it finds is fitted to all rows at last.
///
/// A mean stands at the mean time of its rows. Of what goes straight from row to row it is exact
/// there; what holds until the next row has the mean over that time, so that a lag gets what it
/// got; readings are the mean of those that there are. No mean is over two runs or two clampings.
/// Accuracy: good for lags far slower than the spacing (15 s of 34 h, 75 s of a week).
[[nodiscard]] std::shared_ptr<const record::Record> for_search(
    std::shared_ptr<const record::Record> record);

}  // namespace raceway::tolerance
