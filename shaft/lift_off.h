#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shaft/shaft_prediction.h"

namespace raceway::shaft {

/// Kind of insufficient load on a bearing in a set.
enum class Unloaded {
  no_contact,     ///< the inner contacts are open and carry no load
  below_minimum,  ///< loaded, but below BearingInSet::minimum_load: balls may skid
};

/// A range of speeds in which some bearings of a shaft have too little load.
struct UnloadedRange {
  Unloaded what = Unloaded::no_contact;
  std::vector<std::size_t> bearings;  ///< all bearings with this range, front set first
  ShaftPoint first;                   ///< start of the range
  double end = unset;  ///< speed at the end; NaN if the range lasts to the last point [rad/s]
  /// Axial load and minimum load of the first bearing in `bearings`, at the start of the range [N].
  double load = unset, minimum_load = unset;
};

/// Returns the ranges of speed in which bearings of a shaft lose their inner contacts, then the
/// ranges in which bearings fall below their minimum load. Within each of these two groups, the
/// ranges are sorted by their first bearing, then by speed. The function finds start and end
/// between two converged points by bisection, to half an rpm. The speed must rise from point to
/// point. A range that lies entirely between two points is not found. `predictions` are the results
/// at `points`, in order.
[[nodiscard]] std::vector<UnloadedRange> unloaded_ranges(
    const Model& model, std::span<const ShaftPoint> points,
    std::span<const ShaftPrediction> predictions);

}  // namespace raceway::shaft
