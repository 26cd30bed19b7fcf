#pragma once

#include <cstddef>

namespace raceway::friction::contact {

// Interface of many_contacts.cpp to contact_kernel_*.cpp: the laws of contact_friction.h for
// several contacts in parallel. There is one source file for each instruction set.

inline constexpr std::size_t contacts_of_block = 16;
inline constexpr std::size_t most_kernel_rings = 16, most_kernel_angles = 16;

/// Constants that all contacts of one kernel call have in common: race, law and integration points.
/// Names are as in contact_friction.h. Values that differ between contacts, such as load and speed,
/// are not included in the factors.
struct KernelRace {
  bool flooded, starves;  ///< true if inlets are flooded; true if inlet_over_b is given
  // Shape of the contact, see ContactShape.
  double unit_major_axis, ellipse_ratio, pressed_radius;
  // Factors of the film thickness h = factor · (η u)^n α^m Q^-q in isothermal_film(); composite
  // roughness, and B and C of asperity_share().
  double central_factor, minimum_factor, roughness, asperities_B, asperities_C;
  // m - 1 of starvation_factors(), and the factors of m* - 1 = factor · (h/b²)^n.
  double inlet_excess, starved_central, starved_minimum;
  // Factors of IVR, EHL and M in rolling_force(), without the powers of η, u, α and Q. Factors of
  // ContactLaw on rolling resistance and hysteresis.
  double rigid_factor, elastic_factor, moes_factor, rolling_factor, hysteresis_factor;
  // Constants of FilmShear and Roelands.
  double eyring_stress, limiting_traction, boundary_friction, glass, reference_pressure;
  /// Integration points of half the ellipse if the ball spins, else of a quarter: p/p0 and weight
  /// of each ring, and sines and cosines of the angles. `copies` is the number of these halves or
  /// quarters in the whole ellipse.
  std::size_t rings, angles;
  double s[most_kernel_rings], radius[most_kernel_rings], weight[most_kernel_rings];
  double cosine[most_kernel_angles], sine[most_kernel_angles];
  double copies;
};

/// Inputs and results of contacts that are computed in parallel. Speeds and loads must be above 0.
struct ContactBlock {
  // For each contact: Q [N], |u| [m/s], |ω_roll|, ω_s [rad/s]; for its oil: η [Pa s], α [1/Pa],
  // L/u² [s²/m²]; φ_rs [1].
  alignas(64) double load[contacts_of_block], speed[contacts_of_block], rolling[contacts_of_block],
      spin[contacts_of_block], viscosity[contacts_of_block],
      pressure_viscosity[contacts_of_block], loading[contacts_of_block], supply[contacts_of_block];
  // Results of each contact: power losses [W]; minimum film h_min [m]; Σ|τ|/Q [1], Σ p |v|/Q [m/s];
  // 1 if the sliding solution was found, else 0.
  alignas(64) double sliding[contacts_of_block], rolled[contacts_of_block],
      hysteresis[contacts_of_block], film[contacts_of_block], friction[contacts_of_block],
      slip[contacts_of_block], found[contacts_of_block];
};

using ContactKernel = void (*)(const KernelRace& race, bool spins, ContactBlock* blocks,
                               std::size_t count);
void contact_kernel_sse2(const KernelRace& race, bool spins, ContactBlock* blocks,
                         std::size_t count);
void contact_kernel_avx2(const KernelRace& race, bool spins, ContactBlock* blocks,
                         std::size_t count);
void contact_kernel_avx512(const KernelRace& race, bool spins, ContactBlock* blocks,
                           std::size_t count);

}  // namespace raceway::friction::contact
