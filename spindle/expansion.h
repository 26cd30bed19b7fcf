#pragma once

#include <span>

#include "record/units.h"

namespace raceway::spindle {

/// A length of shaft or housing with one section and one temperature.
struct HeatedLength {
  double length = unset;             ///< [m]
  double area = unset;               ///< [m²]
  double elastic_modulus = unset;    ///< [Pa]
  double thermal_expansion = unset;  ///< [1/K]
  double rise = unset;               ///< mean temperature above the mounting temperature [K]
};

/// Returns the free elongation, the integral of α ΔT over the length [m].
[[nodiscard]] double free_elongation(std::span<const HeatedLength> lengths);

/// Computes the node displacements of a bar fixed at its left end, with substitute forces E A α ΔT
/// that pull on both nodes of each length [m]. `nodes` has one entry more than `lengths`. The last
/// displacement is the free elongation, because the forces balance the thermal expansion for any
/// stiffness.
/// Source: [Brecher2021, 3.1].
void displace_by_substitute_forces(std::span<const HeatedLength> lengths, std::span<double> nodes);

/// Returns the force in a bar fixed at both ends, positive in tension [N]: N = -∫ α ΔT ds / ∫ ds/(E
/// A). For a single section, N = -E A α mean(ΔT).
[[nodiscard]] double force_if_held(std::span<const HeatedLength> lengths);

}  // namespace raceway::spindle
