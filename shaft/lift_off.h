#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shaft/shaft_prediction.h"

namespace raceway::shaft {

/// State of a bearing in a set that carries too little.
enum class Unloaded {
  no_contact,     ///< its inner contacts are lost: it carries nothing
  below_minimum,  ///< in contact, but below BearingInSet::minimum_load: balls may skid
};

/// A range of speeds in which some bearings of a shaft carry too little.
struct UnloadedRange {
  Unloaded what = Unloaded::no_contact;
  std::vector<std::size_t> bearings;  ///< all with this range, front set first
  ShaftPoint first;                   ///< where it begins
  double end = unset;  ///< speed at which it is over, NaN where it lasts to the last point [rad/s]
  double load = unset, minimum_load = unset;  ///< of the first of the bearings, where it begins [N]
};

/// Ranges of speed in which the bearings of a shaft lose their inner contacts, then ranges in which
/// they fall below their minimum load, by bearing and speed. Begin and end are found between the
/// points, which rise in speed, to half an rpm; a range that lies between two points is not seen.
/// `predictions` belong to the points.
[[nodiscard]] std::vector<UnloadedRange> unloaded_ranges(
    const Model& model, std::span<const ShaftPoint> points,
    std::span<const ShaftPrediction> predictions);

}  // namespace raceway::shaft
