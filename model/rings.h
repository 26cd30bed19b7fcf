#pragma once

#include <vector>

#include "bearing/arrangement.h"
#include "model/spindle.h"

namespace raceway::model {

/// The rings of a bearing on the shaft and the seats that they sit on, whatever rolls between them.
/// Diameters.
struct Rings {
  double position = unset;                      ///< of their middle, behind the nose face [m]
  double width = unset;                         ///< [m]
  double bore = unset, outer_diameter = unset;  ///< of the bearing [m]
  /// Diameters of the inner ring outside and of the outer ring inside: shoulders next to the balls,
  /// raceways of rollers [m].
  double inner_shoulder = unset, outer_shoulder = unset;
  double inner_interference = unset, outer_clearance = unset;  ///< diametral, cold and still [m]
  [[nodiscard]] double front() const { return position - 0.5 * width; }
  [[nodiscard]] double rear() const { return position + 0.5 * width; }
};

/// Rings of all bearings on the shaft: front set, rear set, then the roller bearings. Throws
/// std::invalid_argument for another number of positions than of bearings in the sets.
[[nodiscard]] std::vector<Rings> rings_of(const Spindle& spindle, const bearing::Arrangement& sets);

}  // namespace raceway::model
