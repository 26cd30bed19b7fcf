#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bearing/arrangement.h"
#include "model/spindle.h"

namespace raceway::model {

/// Rings of a ball or roller bearing on the shaft, and the seats of the rings.
struct Rings {
  double position = unset;  ///< axial distance from the nose face to the middle of the bearing [m]
  double width = unset;     ///< [m]
  double bore = unset, outer_diameter = unset;  ///< bore and outer diameter of the bearing [m]
  /// Outer diameter of the inner ring and inner diameter of the outer ring [m]: at the shoulders of
  /// a ball bearing, or at the raceways of a roller bearing.
  double inner_shoulder = unset, outer_shoulder = unset;
  /// Diametral interference of the inner seat and clearance of the outer seat, cold and at
  /// standstill [m].
  double inner_interference = unset, outer_clearance = unset;
  [[nodiscard]] double front() const { return position - 0.5 * width; }
  [[nodiscard]] double rear() const { return position + 0.5 * width; }
};

/// Returns the rings of all bearings on the shaft: front set, rear set, then the roller bearings.
/// Throws std::invalid_argument if the number of bearing positions differs from the number of
/// bearings in the sets.
[[nodiscard]] std::vector<Rings> rings_of(const Spindle& spindle, const bearing::Arrangement& sets);

/// Returns the names of all bearings in the order of rings_of(). `front` and `rear` are the numbers
/// of bearings in the sets. The bearings of the sets have the names front_1, rear_1 and so on.
/// Roller bearings have the names in `rollers`.
[[nodiscard]] std::vector<std::string> bearing_names(std::size_t front, std::size_t rear,
                                                     std::span<const RollerOnShaft> rollers);

}  // namespace raceway::model
