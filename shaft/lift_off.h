#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shaft/shaft_prediction.h"

namespace raceway::shaft {

/// State of a bearing in a set with too little load.
enum class Unloaded {
  no_contact,     ///< the inner contacts are open and carry no load
  below_minimum,  ///< loaded, but below BearingInSet::minimum_load: balls may skid
};

/// A range of speeds in which some bearings of a shaft have too little load.
struct UnloadedRange {
  Unloaded what = Unloaded::no_contact;
  std::vector<std::size_t> bearings;  ///< all bearings with this range, front set first
  ShaftPoint first;                   ///< start of the range
  double end = unset;  ///< end of the range; NaN if it lasts to the last point [rad/s]
  /// loads of the first of these bearings at the start [N]
  double load = unset, minimum_load = unset;
};

/// Returns the ranges of speed in which bearings of a shaft lose their inner contacts, then the
/// ranges in which they fall below their minimum load, each in the order of bearing and speed. The
/// function finds start and end between the points by bisection, to half an rpm. The points must
/// rise in speed. A range that lies entirely between two points is not found. `predictions` are the
/// results at `points`, in order.
[[nodiscard]] std::vector<UnloadedRange> unloaded_ranges(
    const Model& model, std::span<const ShaftPoint> points,
    std::span<const ShaftPrediction> predictions);

}  // namespace raceway::shaft
