#pragma once

#include <algorithm>
#include <cmath>

#include "record/units.h"

namespace raceway::friction::contact {

/// Inputs of the laws for film thickness and rolling resistance: a rolling contact and the oil at
/// the inlet.
struct RollingInlet {
  double viscosity = unset;           ///< η of the oil at ambient pressure [Pa s]
  double pressure_viscosity = unset;  ///< α [1/Pa]
  double speed = unset;               ///< u, mean surface speed relative to the cage [m/s], >= 0
  double modulus = unset;             ///< E' = 2/((1-ν1²)/E1 + (1-ν2²)/E2) [Pa]
  double radius_along = unset;        ///< R_x, equivalent radius along rolling [m]
  double load = unset;                ///< Q [N]
};

/// Film thickness of a point contact [m].
struct Film {
  double central = 0.0;  ///< h_c, thickness at the centre of the contact
  double minimum = 0.0;  ///< h_min, thickness at the sides of the contact
};

/// Film thickness of a flooded elliptical contact without inlet heating [m].
///
///   h_c/R_x   = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))
///   h_min/R_x = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
///   U = η u/(E' R_x),   G = α E',   W = Q/(E' R_x²),   k = a/b of the exact ellipse
///
/// Source:   [HamrockDowson1977], with constants as in several public programs.
/// Domain:   Q > 0, rolling along the short axis of the ellipse; the film is zero at standstill.
///           The formula was fitted for U from about 1e-12 to 1e-11, W from 1e-7 to 1e-6, k from 1
///           to 8. In spindle bearings, U is up to ten times the largest fitted value.
/// Accuracy: the code agrees with the formula to rounding error; measured films differ from the
///           formula by 10 to 20 %.
/// Trap:     U here is half the U of rolling_force().
[[nodiscard]] inline Film isothermal_film(const RollingInlet& c, double ellipse_ratio) {
  if (!(c.speed > 0.0)) return {};  // powers of speed: infinite slope at 0
  const double U = c.viscosity * c.speed / (c.modulus * c.radius_along);
  const double G = c.pressure_viscosity * c.modulus;
  const double W = c.load / (c.modulus * c.radius_along * c.radius_along);
  return {.central = c.radius_along * 2.69 * std::pow(U, 0.67) * std::pow(G, 0.53) *
                     std::pow(W, -0.067) * (1.0 - 0.61 * std::exp(-0.73 * ellipse_ratio)),
          .minimum = c.radius_along * 3.63 * std::pow(U, 0.68) * std::pow(G, 0.49) *
                     std::pow(W, -0.073) * (1.0 - std::exp(-0.68 * ellipse_ratio))};
}

/// Thermal loading of an inlet, L = η β u²/k_f [1]: the ratio of shear heating to conduction. η, β
/// and k_f are the viscosity, viscosity slope and conductivity of OilState; u is the mean surface
/// speed of RollingInlet.
[[nodiscard]] inline double thermal_loading(double viscosity, double viscosity_slope, double speed,
                                            double conductivity) {
  return viscosity * viscosity_slope * speed * speed / conductivity;
}

/// Factor on the isothermal film thickness that accounts for inlet heating [1].
///
///   φ_T = 1/(1 + 0.1 (1 + 14.8 S^0.83) L^0.64)
///
/// L is thermal_loading(). The slip ratio S = |u1 - u2|/u of the speeds u1 and u2 of both surfaces
/// is zero for pure rolling.
/// Source:   a published report on roller bearings; the original paper was not checked. Other
///           publications use (1 - 13.2 p/E' L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64), with the
///           peak pressure p and the modulus E'. This other formula gives a thinner film.
/// Domain:   L >= 0, S >= 0; the factor is 1 at L = 0. Accuracy: 10 % up to L = 1; the formula is
///           extrapolated above L = 1.
[[nodiscard]] inline double thermal_film_factor(double loading, double slip_ratio = 0.0) {
  if (!(loading > 0.0)) return 1.0;
  const double slip = slip_ratio > 0.0 ? 1.0 + 14.8 * std::pow(slip_ratio, 0.83) : 1.0;
  return 1.0 / (1.0 + 0.1 * slip * std::pow(loading, 0.64));
}

/// Factors on the flooded film thickness for a starved contact [1].
///
///   central  ((m - 1)/(m* - 1))^0.29,   m* = 1 + 3.06 ((R_x/b)² H_c)^0.58
///   minimum  ((m - 1)/(m* - 1))^0.25,   m* = 1 + 3.34 ((R_x/b)² H_min)^0.56,   H = h/R_x
///
/// m is the distance from the contact centre to the edge of the oil, divided by b, the semi-minor
/// axis of the ellipse. The film thickness h is the result of isothermal_film().
/// Source:   [HamrockDowson1977, part 4], not checked against the paper or a program.
/// Domain:   m > 1. A factor is 1 for m >= m*, so a film is never thicker than the flooded film.
struct StarvationFactors {
  double central = 1.0, minimum = 1.0;
};

[[nodiscard]] inline StarvationFactors starvation_factors(const Film& flooded, double radius_along,
                                                          double semi_minor_axis,
                                                          double inlet_over_b) {
  const auto factor = [&](double film, double c, double inner, double outer) {
    const double r = radius_along / semi_minor_axis;
    const double reach = c * std::pow(r * r * film / radius_along, inner);  // m* - 1
    return inlet_over_b - 1.0 < reach ? std::pow((inlet_over_b - 1.0) / reach, outer) : 1.0;
  };
  return {.central = factor(flooded.central, 3.06, 0.58, 0.29),
          .minimum = factor(flooded.minimum, 3.34, 0.56, 0.25)};
}

/// Composite roughness Rq from the roughness Rq of race and ball, sqrt(race² + ball²) [m].
[[nodiscard]] inline double composite_roughness(double race, double ball) {
  return std::sqrt(race * race + ball * ball);
}

/// Film ratio Λ = h_min/composite roughness [1].
[[nodiscard]] inline double film_ratio(const Film& film, double composite_roughness) {
  return film.minimum / composite_roughness;
}

/// Constants B and C of asperity_share() [1].
struct AsperityLaw {
  double B = 1.8, C = 1.2;
};

/// Share of the load that asperities carry [1]: 1 at standstill, near 0 with a full film.
///
///   φ = exp(-B Λ^C)
///
/// Source:   [ZhouHoeprich1991], not checked against the paper. The formula comes from a published
///           simulation of roller bearings, which uses B = 2.32 and C = 0.97. B and C depend on the
///           surface finish. The defaults 1.8 and 1.2 have no checked source.
/// Domain:   Λ >= 0. Accuracy: near Λ = 1, the values of φ for different surface finishes differ by
///           a factor of 2.
[[nodiscard]] inline double asperity_share(double film_ratio, const AsperityLaw& law = {}) {
  if (!(film_ratio > 0.0)) return 1.0;
  return std::exp(-law.B * std::pow(film_ratio, law.C));
}

}  // namespace raceway::friction::contact
