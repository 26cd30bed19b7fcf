#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/spindle_study/machine.h"

namespace spindle_study {

enum class Part { shaft, inner_ring, outer_ring, housing };

struct Cell {
  Part part;
  int bearing = -1;                                             ///< of a ring
  double x0, x1, r0, r1;                                        ///< [m]
  double capacity = nan;                                        ///< [J/K]
  double half_inner = nan, half_outer = nan, half_axial = nan;  ///< conductances to the faces [W/K]
  [[nodiscard]] double x() const { return 0.5 * (x0 + x1); }
  [[nodiscard]] double r() const { return 0.5 * (r0 + r1); }
  [[nodiscard]] double cylinder(double radius) const { return 2.0 * pi * radius * (x1 - x0); }
  [[nodiscard]] double disc() const { return pi * (r1 * r1 - r0 * r0); }
};

enum class LinkKind { solid, inner_seat, outer_seat, gap };

/// Two cells that touch, or face each other over the gap.
struct Link {
  std::size_t a, b;
  LinkKind kind = LinkKind::solid;
  double half_a = nan, half_b = nan;  ///< [W/K]; the film of a seat or gap lies between
  double area = nan;                  ///< of that film [m²]
  int bearing = -1;
  double inner_radius = nan, outer_radius = nan;  ///< of a gap [m]
};

enum class FaceKind { housing_cylinder, housing_end, nose, rear, flange, channel };

/// A face to the room, the machine or the coolant.
struct Face {
  std::size_t cell;
  FaceKind kind;
  double half = nan, area = nan;
  double length = nan;  ///< of its film law: diameter or height [m]
};

/// Raceways of one bearing in one column: heat arises and passes between them.
struct Raceway {
  std::size_t inner, outer;  ///< cells
  double half_inner = nan, half_outer = nan;
  double share = nan;  ///< of the width
  int bearing = -1;
};

/// Weights on cells.
using Weights = std::vector<std::pair<std::size_t, double>>;

struct Mesh {
  std::vector<Cell> cells;
  std::vector<Link> links;
  std::vector<Face> faces;
  std::vector<Raceway> raceways;
  std::vector<Weights> inner_rings, outer_rings;    ///< means of rings, by volume
  std::vector<Weights> shaft_seats, housing_seats;  ///< means of what carries them
  Weights elongation;  ///< ∫ (α_s dT_s - α_h dT_h) between the sets [m/K]
  Weights nose;        ///< nose against flange without the set's own motion [m/K]
  std::vector<Weights> thermometers;
};

/// Cells of at most `size` [m] along both axes.
[[nodiscard]] Mesh make_mesh(const Spindle& spindle, double size);

}  // namespace spindle_study
