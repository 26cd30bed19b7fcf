#pragma once

#include <vector>

#include "model/spindle.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Temperature at a radius of a round part.
struct RadialTemperature {
  double radius = unset;       ///< [m]
  double temperature = unset;  ///< [K]
};

/// Shaft or ring section with free ends.
struct RoundPart {
  model::SolidMaterial material = {};
  /// Temperatures at two or more ascending radii, from the bore to the outer surface. For a solid
  /// cylinder, the first radius is 0. Between two radii, the temperature is linear in ln r. Between
  /// the axis of a solid cylinder and the second radius, the temperature is uniform.
  std::vector<RadialTemperature> profile = {};
  double bore_pressure = 0.0, surface_pressure = 0.0;  ///< [Pa]
  double speed = 0.0;                                  ///< [rad/s]
};

/// Returns the stresses of a part at the radii of its temperature profile. The part is in
/// generalised plane strain without axial force.
///
///   heat      J(r) = ∫ T r dr from a to r,   k = E α/(1 - ν)
///             σr = k ((r² - a²)/(b² - a²) J(b) - J(r))/r²
///             σθ = k (((r² + a²)/(b² - a²) J(b) + J(r))/r² - T),   σz = k (2 J(b)/(b² - a²) - T)
///   fit       σr, σθ = (p_a a² - p_b b² -/+ (p_a - p_b) a² b²/r²)/(b² - a²),   σz = 0
///   rotation  σr = c (a² + b² - a² b²/r² - r²),   c = ρ ω² (3 - 2ν)/(8 (1 - ν))
///             σθ = c (a² + b² + a² b²/r² - (1 + 2ν)/(3 - 2ν) r²)
///             σz = ρ ω² ν/(2 (1 - ν)) ((a² + b²)/2 - r²)
///
/// The sign -/+ is - for σr and + for σθ. a and b are the radii of bore and outer surface, with the
/// pressures p_a and p_b. T is the temperature, E, ν, α and ρ are material data, and ω is the
/// speed. The stresses of heat, fit and rotation are added. Pressures from press_fit() are valid
/// here although press_fit() assumes plane stress, because an axial stress without resultant force
/// does not change the radial growth of bore and outer surface.
/// Source:   heat: Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 150 to 152; fit:
///           Lamé's equations; rotation: the equations of a long rotating cylinder (plane strain).
/// Domain:   sections several wall thicknesses away from ends, steps and grooves of the part.
/// Accuracy: exact to rounding if the true temperature is linear in ln r between the given radii,
///           as in steady radial heat flow. For a transient temperature, the distance between the
///           given radii limits the accuracy.
[[nodiscard]] std::vector<Stress> stresses_of(const RoundPart& part);

}  // namespace raceway::spindle
