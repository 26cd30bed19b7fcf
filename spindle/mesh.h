#pragma once

#include <span>
#include <vector>

#include "model/spindle.h"

namespace raceway::spindle {

enum class Body { shaft, inner_ring, outer_ring, spacer, housing };

/// Ring-shaped or cylindrical body of one material with a rectangular section.
struct Region {
  Body body = Body::shaft;
  int bearing = -1;  ///< index of the bearing of a ring, front set first; -1 for other bodies
  double start = unset, end = unset;  ///< distance behind the nose face [m]
  /// Inner and outer radius [m]; the inner radius of a solid cylinder is 0.
  double inner_radius = unset, outer_radius = unset;
  model::SolidMaterial material = model::steel_of_shafts;
  /// Solid fraction of the cross-section [1]; the remaining section is coolant channel.
  double solid_share = 1.0;
};

/// Cell of the mesh: a whole region or a part of a region.
struct Cell : Region {
  int region = -1;
  int column = -1, row = -1;  ///< axial index (column) and radial index (row) in the grid

  [[nodiscard]] double length() const { return end - start; }
  [[nodiscard]] double section() const;        ///< solid area of the cross-section [m²]
  [[nodiscard]] double heat_capacity() const;  ///< [J/K]
  /// Returns the thermal resistance from the middle of the cell to a face normal to the axis [K/W].
  [[nodiscard]] double half_axial_resistance() const;
  /// Thermal resistance between the middle radius r_m and the inner or outer face r_f,
  /// |ln(r_f/r_m)|/(2 π λ L) [K/W]. λ is `solid_share` times the conductivity of the material, and
  /// L is the length of the cell. The inner resistance of a solid cylinder is infinite.
  [[nodiscard]] double inner_half_resistance() const;
  [[nodiscard]] double outer_half_resistance() const;
  [[nodiscard]] double middle_radius() const { return 0.5 * (inner_radius + outer_radius); }
};

/// Common face of two cells. The face is normal to the axis if `axial` is true, otherwise
/// cylindrical.
struct Touch {
  int first = -1, second = -1;
  bool axial = true;
  double area = unset;  ///< [m²]
  /// Thermal resistances from the middle of each cell to the face [K/W].
  double first_half = unset, second_half = unset;
};

/// Face of a cell without a neighbouring cell.
struct OpenFace {
  int cell = -1;
  enum class Side { front, rear, inner, outer } side = Side::outer;
  double area = unset;  ///< [m²]
  double half = unset;  ///< thermal resistance from the middle of the cell to the face [K/W]
  /// Returns true for a cylindrical face.
  [[nodiscard]] bool radial() const { return side == Side::inner || side == Side::outer; }
};

/// Axisymmetric cells on a common grid of axial and radial lines.
struct Mesh {
  std::vector<Cell> cells;
  std::vector<Touch> touches;
  std::vector<OpenFace> open;

  [[nodiscard]] std::size_t size() const { return cells.size(); }
  /// Returns the index of the cell of a body that is nearest to `position` [m] and `radius` [m]; -1
  /// if the mesh has no cell of the body.
  [[nodiscard]] int nearest(Body body, double position, double radius) const;
};

/// Divides regions into cells. The grid has lines at the edges of all regions and at the axial
/// positions `lines` [m]. Additional grid lines keep the cells at most `axial` long and `radial`
/// thick [m].
///
/// Domain: regions must not overlap. Throws std::invalid_argument for a region without volume.
[[nodiscard]] Mesh make_mesh(std::span<const Region> regions, double axial, double radial,
                             std::span<const double> lines = {});

/// Returns the thermal conductance between two neighbouring cells of one solid part [W/K].
[[nodiscard]] inline double conductance_of(const Touch& touch) {
  return 1.0 / (touch.first_half + touch.second_half);
}

}  // namespace raceway::spindle
