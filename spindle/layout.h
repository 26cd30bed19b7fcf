#pragma once

#include <vector>

#include "model/model.h"
#include "spindle/mesh.h"

namespace raceway::spindle {

/// Heat path from a cell to another cell, to a fluid or to the surroundings.
struct Joint {
  int first = -1;
  int second = -1;      ///< index of the second cell; -1 for a fluid or the surroundings
  double area = unset;  ///< [m²]
  double half = 0.0;    ///< sum of the thermal resistances from the cells to the joint [K/W]
  bool axial = false;   ///< true for an open face normal to the axis, false for all other joints
};
using Joints = std::vector<Joint>;

/// Weight of one cell in a mean temperature or in a heat source.
struct Share {
  int cell = -1;
  double share = 0.0;  ///< [1]
};
using Shares = std::vector<Share>;

/// Returns the weights for the mean temperature of these cells. The weights are proportional to the
/// cell volumes and have the sum 1.
[[nodiscard]] Shares mean_over(const Mesh& mesh, const std::vector<int>& cells);

/// Position and dimensions of one bearing, and its cells in the mesh.
struct BearingPlace {
  /// Distance of the bearing centre behind the nose face, and width of the bearing [m].
  double position = unset, width = unset;
  double seat_bore = unset, seat = unset;  ///< radii of shaft bore and shaft seat [m]
  double inner_shoulder = unset, outer_shoulder = unset;  ///< shoulder radii [m]
  /// Radii of housing bore and outer surface of the housing [m].
  double housing_seat = unset, housing_outer = unset;
  /// Diametral interference on the shaft and diametral clearance in the housing, cold and at
  /// standstill [m].
  double inner_interference = unset, outer_clearance = unset;
  Joints inner_seat, outer_seat;
  Joints inner_raceway, outer_raceway;  ///< heat paths from ring cells to the raceway
  Shares inner_ring, outer_ring;        ///< weights of the cells for the mean ring temperatures
  Shares shaft_below, housing_above;    ///< weights of shaft and housing cells at the seats
};

/// Side face of a bearing ring that a clamping force presses against a shoulder, a spacer or
/// another ring. The face between two rings is listed once, as the rear face of the front ring.
struct ClampedFace {
  int bearing = -1;      ///< index of the bearing in Layout::bearings
  bool inner = true;     ///< true for an inner ring, false for an outer ring
  bool rear = false;     ///< true for a rear face, false for a front face
  double force = unset;  ///< [N]
  Joints joints;         ///< heat paths through the face; `first` is the ring cell
};

/// Cells, joints and dimensions of a spindle that do not depend on the operating point.
struct Layout {
  Mesh mesh;
  std::vector<BearingPlace> bearings;  ///< in the order front set, rear set, roller bearings
  Joints shoulders, collars;
  /// Joints between spacers and inner rings; empty if the model gives the clamping force of the
  /// inner rings, because `faces` then contains these joints.
  Joints clamped;
  std::vector<ClampedFace> faces;  ///< side faces of rings with clamping force
  Joints housing_cylinder, housing_ends, nose, rear, flange;
  Joints gap;
  /// Walls of each coolant channel, in the order of model::Spindle::channels().
  std::vector<Joints> coolant_walls;
  /// Positions of the front face of the first bearing and of the rear face of the last bearing [m].
  double first_bearing_front = unset, last_bearing_rear = unset;
  double housing_start = unset, housing_end = unset;  ///< [m]
  /// Positions of the centres of the bearing sets [m]; `rear_centre` is NaN without a rear set.
  double front_centre = unset, rear_centre = unset;

  /// Returns the material of the first cell in `seat`.
  [[nodiscard]] const model::SolidMaterial& material(const Shares& seat) const {
    return mesh.cells[static_cast<std::size_t>(seat.front().cell)].material;
  }
  /// Returns the weights of the cells that a heat source between two axial positions heats. The
  /// weights are proportional to the cell volumes. If `radius` [m] is not NaN, only cells at this
  /// radius are used. If no cell lies between the positions at this radius, the nearest cell of the
  /// body is used.
  [[nodiscard]] Shares source(Body body, double from, double to, double radius = unset) const;
};

/// Returns the layout of a spindle. Throws std::invalid_argument if parts do not fit together, or
/// if the model is not a spindle with [shaft] and [housing].
[[nodiscard]] Layout make_layout(const model::Model& model, model::Cells cells);

/// Returns the regions of shaft, housing, rings and spacers before their division into cells.
[[nodiscard]] std::vector<Region> regions_of(const model::Model& model);

}  // namespace raceway::spindle
