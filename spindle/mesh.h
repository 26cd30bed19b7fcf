#pragma once

#include <span>
#include <vector>

#include "model/spindle.h"

namespace raceway::spindle {

enum class Body { shaft, inner_ring, outer_ring, spacer, housing };

/// A full ring of one material with rectangular section.
struct Region {
  Body body = Body::shaft;
  int bearing = -1;                   ///< index of the bearing for a ring, front set first
  double start = unset, end = unset;  ///< distance behind the nose face [m]
  double inner_radius = unset, outer_radius = unset;  ///< [m]; 0 for a full cylinder
  model::SolidMaterial material = model::steel_of_shafts;
  double solid_share = 1.0;  ///< solid share of its section; the remainder is a channel [1]
};

/// A cell: part of a region or the whole region.
struct Cell : Region {
  int region = -1;
  int column = -1, row = -1;  ///< column and row in the grid

  [[nodiscard]] double length() const { return end - start; }
  [[nodiscard]] double section() const;        ///< solid section across the axis [m²]
  [[nodiscard]] double heat_capacity() const;  ///< [J/K]
  /// Returns the resistance from the middle to a face normal to the axis [K/W].
  [[nodiscard]] double half_axial_resistance() const;
  /// Returns the resistance from the middle radius to the inner or outer face, ln(r_f/r_m)/(2 π λ
  /// L) [K/W].
  [[nodiscard]] double inner_half_resistance() const;
  [[nodiscard]] double outer_half_resistance() const;
  [[nodiscard]] double middle_radius() const { return 0.5 * (inner_radius + outer_radius); }
};

/// Contact of two cells: through a face normal to the axis (`axial`) or through a cylindrical face.
struct Touch {
  int first = -1, second = -1;
  bool axial = true;
  double area = unset;                             ///< [m²]
  double first_half = unset, second_half = unset;  ///< resistances to the common face [K/W]
};

/// A face of a cell without a neighbour.
struct OpenFace {
  int cell = -1;
  enum class Side { front, rear, inner, outer } side = Side::outer;
  double area = unset;  ///< [m²]
  double half = unset;  ///< resistance from the middle of the cell [K/W]
  /// Returns true for a cylindrical face.
  [[nodiscard]] bool radial() const { return side == Side::inner || side == Side::outer; }
};

/// Axisymmetric cells on one grid.
struct Mesh {
  std::vector<Cell> cells;
  std::vector<Touch> touches;
  std::vector<OpenFace> open;

  [[nodiscard]] std::size_t size() const { return cells.size(); }
  /// Returns the cell of a body at a place, or the cell of the body that is nearest to the place;
  /// -1 if the mesh has no cell of the body.
  [[nodiscard]] int nearest(Body body, double position, double radius) const;
};

/// Divides regions into cells. The grid has lines at the edges of all regions and at `lines`.
/// Further lines limit the size of all cells to `axial` along the axis and to `radial` across it.
///
/// Domain: regions do not overlap. Throws std::invalid_argument for a region without volume.
[[nodiscard]] Mesh make_mesh(std::span<const Region> regions, double axial, double radial,
                             std::span<const double> lines = {});

/// Returns the conductance between touching cells of one solid, from their half resistances in
/// series [W/K].
[[nodiscard]] inline double conductance_of(const Touch& touch) {
  return 1.0 / (touch.first_half + touch.second_half);
}

}  // namespace raceway::spindle
