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

/// Range of speeds in which one or more bearings of a shaft have too little load.
struct UnloadedRange {
  Unloaded what = Unloaded::no_contact;
  /// Indices of the bearings that have too little load in exactly this range, front set first.
  std::vector<std::size_t> bearings;
  ShaftPoint first;    ///< start of the range
  double end = unset;  ///< speed at the end; NaN if the range lasts to the last point [rad/s]
  /// Axial load and minimum load of the first bearing in `bearings`, at the start of the range [N].
  double load = unset, minimum_load = unset;
};

/// Returns the speed ranges in which bearings of a shaft have too little load: first the ranges
/// without inner contacts, then the ranges below the minimum load. Each of these two groups is
/// sorted by the first bearing of the range, then by speed. The speed of `points` must rise from
/// point to point. `predictions` are the results at `points`, in the same order. Between two
/// converged points, the function finds the start or end of a range by bisection, to within 0.5
/// rpm. Next to a point without equilibrium, the range starts or ends at the converged point. A
/// range that lies entirely between two points is not found.
[[nodiscard]] std::vector<UnloadedRange> unloaded_ranges(
    const Model& model, std::span<const ShaftPoint> points,
    std::span<const ShaftPrediction> predictions);

}  // namespace raceway::shaft
