#pragma once

#include <span>

#include "record/units.h"

namespace raceway::spindle {

/// Axial section of shaft or housing with one cross-section and one mean temperature.
struct HeatedLength {
  double length = unset;             ///< [m]
  double area = unset;               ///< [m²]
  double elastic_modulus = unset;    ///< [Pa]
  double thermal_expansion = unset;  ///< [1/K]
  double rise = unset;               ///< mean temperature above the mounting temperature [K]
};

/// Returns the free thermal elongation, the sum of α ΔT times length over all `lengths` [m].
[[nodiscard]] double free_elongation(std::span<const HeatedLength> lengths);

/// Computes the axial displacements of the section ends in a bar that is fixed at the start of its
/// first section, and writes them to `nodes` [m]. The function replaces the thermal expansion by
/// forces E A α ΔT that pull at both ends of each section. E, A, α and ΔT are the elastic modulus,
/// area, thermal expansion coefficient and temperature rise of the section. `nodes` has one element
/// more than `lengths`. The last element is the free elongation, which does not depend on the
/// stiffness.
/// Source: [Brecher2021, 3.1].
void displace_by_substitute_forces(std::span<const HeatedLength> lengths, std::span<double> nodes);

/// Returns the axial force N = -∫ α ΔT ds / ∫ ds/(E A) in a bar fixed at both ends, positive in
/// tension [N]. s is the axial position, and the other symbols are the members of HeatedLength. For
/// a constant cross-section, N = -E A α mean(ΔT).
[[nodiscard]] double force_if_held(std::span<const HeatedLength> lengths);

}  // namespace raceway::spindle
