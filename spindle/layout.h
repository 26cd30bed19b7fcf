#pragma once

#include <vector>

#include "model/model.h"
#include "spindle/mesh.h"

namespace raceway::spindle {

/// Heat path between two cells through a joint, or from a cell to a fluid or the surroundings.
struct Joint {
  int first = -1;
  int second = -1;      ///< second cell; -1: a fluid or the surroundings
  double area = unset;  ///< [m²]
  double half = 0.0;    ///< resistance from the cells to the joint [K/W]
  bool axial = false;   ///< true: the face is normal to the axis
};
using Joints = std::vector<Joint>;

/// Weight of one cell in a mean temperature or in the distribution of a heat source.
struct Share {
  int cell = -1;
  double share = 0.0;  ///< [1]
};
using Shares = std::vector<Share>;

/// Returns the weights of these cells in their mean temperature, by volume, with the sum 1.
[[nodiscard]] Shares mean_over(const Mesh& mesh, const std::vector<int>& cells);

/// Position of one bearing in the mesh of cells.
struct BearingPlace {
  double position = unset, width = unset;  ///< [m]
  double seat_bore = unset, seat = unset;  ///< radii of shaft bore and inner seat [m]
  double inner_shoulder = unset, outer_shoulder = unset;  ///< radii [m]
  double housing_seat = unset, housing_outer = unset;     ///< radii [m]
  /// diametral, cold and at standstill [m]
  double inner_interference = unset, outer_clearance = unset;
  Joints inner_seat, outer_seat;
  Joints inner_raceway, outer_raceway;  ///< paths from cells to the raceway
  Shares inner_ring, outer_ring;        ///< weights of the mean temperatures
  Shares shaft_below, housing_above;    ///< weights for shaft and housing at the seats
};

/// Side face of a ring that a clamping force presses against its neighbour: a shoulder, a spacer or
/// another ring. Between two rings, the rear face of one is also the front face of the other.
struct ClampedFace {
  int bearing = -1;      ///< index of the ring in Layout::bearings
  bool inner = true;     ///< true: inner ring
  bool rear = false;     ///< true: rear face
  double force = unset;  ///< [N]
  Joints joints;         ///< paths from the cells of the ring
};

/// All cells and joints of a spindle, with all data that do not depend on the operating point.
struct Layout {
  Mesh mesh;
  std::vector<BearingPlace> bearings;  ///< order as in model::rings_of()
  Joints shoulders, collars;
  Joints clamped;                  ///< spacers to inner rings, without a clamping force
  std::vector<ClampedFace> faces;  ///< faces with a clamping force, not in the groups above
  Joints housing_cylinder, housing_ends, nose, rear, flange;
  Joints gap;
  std::vector<Joints> coolant_walls;  ///< walls of each channel in model::Spindle::channels()
  double first_bearing_front = unset, last_bearing_rear = unset;  ///< outermost ring faces [m]
  double housing_start = unset, housing_end = unset;              ///< [m]
  /// centres of the sets [m]; NaN without a rear set
  double front_centre = unset, rear_centre = unset;
  std::vector<double> helix_length;  ///< length of each coolant channel [m]

  /// Returns the material of the first cell of a seat.
  [[nodiscard]] const model::SolidMaterial& material(const Shares& seat) const {
    return mesh.cells[static_cast<std::size_t>(seat.front().cell)].material;
  }
  /// Returns the weights of the cells of a heat source between two planes, by volume. If `radius`
  /// is given, only cells at this radius are used. If no cell lies there, the nearest cell is used.
  [[nodiscard]] Shares source(Body body, double from, double to, double radius = unset) const;
};

/// Builds the layout. Throws std::invalid_argument if parts cannot be mounted; the message has
/// name, value with unit and allowed range.
[[nodiscard]] Layout make_layout(const model::Model& model, model::Cells cells);

/// Returns shaft, housing, rings and spacers as regions, before their division into cells.
[[nodiscard]] std::vector<Region> regions_of(const model::Model& model);

}  // namespace raceway::spindle
