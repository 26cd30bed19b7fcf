#pragma once

#include "bearing/geometry.h"
#include "bearing/material.h"

namespace raceway::bearing {

enum class Race { inner, outer };

/// Curvature sum and curvature difference of a contact between ball and groove.
struct Curvature {
  double sum = unset;         ///< Σρ [1/m]
  double difference = unset;  ///< F(ρ) [1], in [0, 1)
};

/// Returns the curvature sum [1/m] and the curvature difference [1] of the contact between ball and
/// groove at the contact angle α:
///
///   Σρ D = 4 - 1/f ± 2γ/(1 ∓ γ),   F(ρ) Σρ D = 1/f ± 2γ/(1 ∓ γ),   γ = D cos α / d_m
///
/// f is the conformity of the race, D the ball diameter, and d_m the pitch diameter. The upper
/// signs apply to the inner race.
/// Source: [Harris2006, vol. 1, eqs. 2.26-2.33].
/// Domain: f > 0.5, γ < 1.
[[nodiscard]] Curvature groove_curvature(const BearingGeometry& geometry, Race race,
                                         double contact_angle);

/// Constants of a Hertz point contact that do not depend on the load.
///
///   Q = K δ^1.5,  a = a* s,  b = b* s,  δ = δ* s² Σρ/2,  s = (3 Q η / (2 Σρ))^(1/3)
///   a* = (2 κ² E / π)^(1/3),  b* = (2 E / (π κ))^(1/3),  δ* = (2 F/π) (π / (2 κ² E))^(1/3)
///   F(ρ) = ((κ² + 1) E - 2 F) / ((κ² - 1) E),  η = (1-ν1²)/E1 + (1-ν2²)/E2
///
/// Q is the load, δ the approach, and a and b are the half axes of the contact ellipse. E1, E2, ν1
/// and ν2 are elastic moduli and Poisson ratios of both bodies. κ = a/b >= 1. F and E are the
/// complete elliptic integrals with the modulus k = sqrt(1 - 1/κ²).
/// Source:   [Harris2006, vol. 1, eqs. 6.25-6.43].
/// Domain:   0 <= F(ρ) < 1. F(ρ) = 0 is a circular contact.
/// Accuracy: the relative error of κ is 1e-14. The theory assumes dry, frictionless, elastic half
///           spaces. For grooves with a conformity f below 0.51, the error of the calculated
///           approach δ is a few per cent.
struct HertzContact {
  double curvature_sum = unset;      ///< Σρ [1/m]
  double ellipse_ratio = unset;      ///< κ = a/b [1]
  double first_integral = unset;     ///< F(k), complete elliptic integral of the first kind [1]
  double second_integral = unset;    ///< E(k), complete elliptic integral of the second kind [1]
  double contact_modulus = unset;    ///< 1/η [Pa]
  double contact_stiffness = unset;  ///< K [N/m^1.5]

  [[nodiscard]] double approach(double load) const;         ///< elastic approach δ [m]
  [[nodiscard]] double load(double approach) const;         ///< load Q [N], 0 for approach <= 0
  [[nodiscard]] double semi_major_axis(double load) const;  ///< a, across the rolling direction [m]
  [[nodiscard]] double semi_minor_axis(double load) const;  ///< b, along the rolling direction [m]
  [[nodiscard]] double peak_pressure(double load) const;    ///< 3 Q / (2 π a b) [Pa]
};

/// Returns the constants of a contact. Throws std::invalid_argument for an invalid material, and
/// for a curvature outside Σρ > 0 and 0 <= F(ρ) < 1.
[[nodiscard]] HertzContact hertz_contact(const Curvature& curvature, const Material& first,
                                         const Material& second);

}  // namespace raceway::bearing
