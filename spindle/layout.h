#pragma once

#include <vector>

#include "model/model.h"
#include "spindle/mesh.h"

namespace raceway::spindle {

/// A way for heat between two cells through a joint, or from a cell to a fluid or the room.
struct Joint {
  int first = -1;
  int second = -1;      ///< -1: to what stands around
  double area = unset;  ///< [m²]
  double half = 0.0;    ///< resistance of the cells up to the joint [K/W]
};
using Joints = std::vector<Joint>;

/// A share of something by cell.
struct Share {
  int cell = -1;
  double share = 0.0;  ///< [1]
};
using Shares = std::vector<Share>;

/// Mean temperature of a body: weights sum up to 1.
[[nodiscard]] Shares mean_over(const Mesh& mesh, const std::vector<int>& cells);

/// One bearing in the cells.
struct BearingPlace {
  double position = unset, width = unset;  ///< [m]
  double seat_bore = unset, seat = unset;  ///< radii of shaft bore and inner seat [m]
  double inner_shoulder = unset, outer_shoulder = unset;       ///< radii [m]
  double housing_seat = unset, housing_outer = unset;          ///< radii [m]
  double inner_interference = unset, outer_clearance = unset;  ///< diametral, cold and still [m]
  Joints inner_seat, outer_seat;
  Joints inner_raceway, outer_raceway;  ///< from cell to raceway
  Shares inner_ring, outer_ring;        ///< mean temperatures
  Shares shaft_below, housing_above;    ///< of what the seats sit on
};

/// All of a spindle's cells and joints, with everything that stays as it is whatever runs.
struct Layout {
  Mesh mesh;
  std::vector<BearingPlace> bearings;  ///< as model::rings_of()
  Joints shoulders, collars;
  Joints clamped;  ///< spacers between rings, ground and pressed together: no barrier
  Joints housing_cylinder, housing_ends, nose, rear, flange;
  Joints gap;
  Joints coolant_walls;
  double first_bearing_front = unset, last_bearing_rear = unset;  ///< outermost faces [m]
  double housing_start = unset, housing_end = unset;              ///< [m]
  double front_centre = unset, rear_centre = unset;  ///< of the sets [m]; NaN without a rear set
  double helix_length = 0.0;                         ///< of the coolant's channel [m]

  /// Material in the middle of a seat.
  [[nodiscard]] const model::SolidMaterial& material(const Shares& seat) const {
    return mesh.cells[static_cast<std::size_t>(seat.front().cell)].material;
  }
  /// Shares of a source between two planes, by volume; with a radius of the cells there alone. The
  /// nearest cell where none lies there.
  [[nodiscard]] Shares source(Body body, double from, double to, double radius = unset) const;
};

/// Throws std::invalid_argument if parts cannot be mounted; the message has name, value with unit
/// and allowed range.
[[nodiscard]] Layout make_layout(const model::Model& model, model::Cells cells);

/// Shaft and housing as a spindle's own parts, nothing cut into cells yet.
[[nodiscard]] std::vector<Region> regions_of(const model::Model& model);

}  // namespace raceway::spindle
