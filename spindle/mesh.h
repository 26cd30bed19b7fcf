#pragma once

#include <span>
#include <vector>

#include "model/spindle.h"

namespace raceway::spindle {

enum class Body { shaft, inner_ring, outer_ring, spacer, housing };

/// A full ring of one material with a rectangular section.
struct Region {
  Body body = Body::shaft;
  int bearing = -1;                                   ///< of a ring: which, front set first
  double start = unset, end = unset;                  ///< behind the nose face [m]
  double inner_radius = unset, outer_radius = unset;  ///< [m]; 0 for a full cylinder
  model::SolidMaterial material = model::steel_of_shafts;
  double solid_share = 1.0;  ///< of its section, the rest is a channel [1]
};

/// A cell of a region, or all of it.
struct Cell : Region {
  int region = -1;
  int column = -1, row = -1;  ///< place in the grid

  [[nodiscard]] double length() const { return end - start; }
  [[nodiscard]] double section() const;        ///< solid, across the axis [m²]
  [[nodiscard]] double heat_capacity() const;  ///< [J/K]
  /// Resistance from the middle to a face across the axis [K/W].
  [[nodiscard]] double half_axial_resistance() const;
  /// Resistance from the middle radius to the inner or the outer face, ln(r_f/r_m)/(2 π λ L) [K/W].
  [[nodiscard]] double inner_half_resistance() const;
  [[nodiscard]] double outer_half_resistance() const;
  [[nodiscard]] double middle_radius() const { return 0.5 * (inner_radius + outer_radius); }
};

/// Two cells that touch: across the axis (`axial`) or along it.
struct Touch {
  int first = -1, second = -1;
  bool axial = true;
  double area = unset;                             ///< [m²]
  double first_half = unset, second_half = unset;  ///< resistances to the common face [K/W]
};

/// A face of a cell that touches no other.
struct OpenFace {
  int cell = -1;
  enum class Side { front, rear, inner, outer } side = Side::outer;
  double area = unset;  ///< [m²]
  double half = unset;  ///< resistance from the middle of the cell [K/W]
  /// Returns true for a face along the axis.
  [[nodiscard]] bool radial() const { return side == Side::inner || side == Side::outer; }
};

/// Axisymmetric cells on the lines of one grid.
struct Mesh {
  std::vector<Cell> cells;
  std::vector<Touch> touches;
  std::vector<OpenFace> open;

  [[nodiscard]] std::size_t size() const { return cells.size(); }
  /// The cell of a body at a place, or the nearest one of it; -1 where the mesh has none.
  [[nodiscard]] int nearest(Body body, double position, double radius) const;
};

/// Cuts regions into cells. Lines of the grid are the edges of all regions and `lines`, and between
/// them as many as keep a cell shorter than `axial` and lower than `radial`.
///
/// Domain: regions do not overlap. Throws std::invalid_argument for a region without volume.
[[nodiscard]] Mesh make_mesh(std::span<const Region> regions, double axial, double radial,
                             std::span<const double> lines = {});

/// Conductance between cells of one solid that touch: their halves in series [W/K].
[[nodiscard]] inline double conductance_of(const Touch& touch) {
  return 1.0 / (touch.first_half + touch.second_half);
}

}  // namespace raceway::spindle
