#pragma once

#include <span>

#include "record/units.h"

namespace raceway::spindle {

/// A length of shaft or housing of one section and temperature.
struct HeatedLength {
  double length = unset;             ///< [m]
  double area = unset;               ///< [m²]
  double elastic_modulus = unset;    ///< [Pa]
  double thermal_expansion = unset;  ///< [1/K]
  double rise = unset;               ///< above the temperature of mounting, mean over it [K]
};

/// Free elongation, the integral of α ΔT over the length [m].
[[nodiscard]] double free_elongation(std::span<const HeatedLength> lengths);

/// Displacements of the nodes of a bar, held at its left end, under the substitute forces
/// E A α ΔT that pull on both nodes of each length: `nodes` has one more than `lengths`
/// [m]. The last of these is the free elongation: the forces are in balance with the expansion
/// whatever the stiffness.
/// Source: [Brecher2021, 3.1].
void displace_by_substitute_forces(std::span<const HeatedLength> lengths, std::span<double> nodes);

/// Force in a bar that is held at both ends, positive in tension [N]:
/// N = -∫ α ΔT ds / ∫ ds/(E A); of one section N = -E A α mean(ΔT).
[[nodiscard]] double force_if_held(std::span<const HeatedLength> lengths);

}  // namespace raceway::spindle
