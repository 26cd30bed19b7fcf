#pragma once

#include <algorithm>
#include <cmath>

#include "record/units.h"

/// Heat through solids that touch.
namespace raceway::spindle {

/// Two rough surfaces that are pressed together.
struct RoughContact {
  double roughness = unset;            ///< Ra [m]
  double slope = unset;                ///< m, mean slope of the surfaces [1]
  double hardness = unset;             ///< H of the softer one [Pa]
  double first_conductivity = unset;   ///< λ1 [W/(m K)]
  double second_conductivity = unset;  ///< λ2 [W/(m K)]
};

/// Conductance of the spots that touch [W/(m² K)].
///
///   1/h = 0.46 (Ra/m)(1/λ1 + 1/λ2)(p/H)^-0.93
///
/// Source:   [Brecher2021, eq. 4], with Ra in m.
/// Domain:   p/H below 0.02 or so; zero where p <= 0.
/// Accuracy: 3 % of yovanovich_contact() from 1 to 10 MPa; real seats differ by a factor of 2.
[[nodiscard]] inline double solid_contact(const RoughContact& c, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  return std::pow(pressure / c.hardness, 0.93) * c.slope /
         (0.46 * c.roughness * (1.0 / c.first_conductivity + 1.0 / c.second_conductivity));
}

/// Conductance of rough contact by Yovanovich [W/(m² K)].
///
///   h = 1.25 (2 λ1 λ2/(λ1 + λ2)) (m/Ra) (p/H)^0.95
///
/// Source:   Yovanovich's fit to Cooper, Mikic and Yovanovich, Int. J. Heat Mass Transfer 12
///           (1969) 279, whose own has 1.45 and 0.985. Ra stands for the rms roughness.
/// Domain:   as solid_contact().
[[nodiscard]] inline double yovanovich_contact(const RoughContact& c, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  const double mean = 2.0 * c.first_conductivity * c.second_conductivity /
                      (c.first_conductivity + c.second_conductivity);
  return 1.25 * mean * c.slope / c.roughness * std::pow(pressure / c.hardness, 0.95);
}

/// λ of the air in gaps of seats [W/(m K)].
inline constexpr double gap_conductivity = 0.027;

/// Conductance of the air between rough surfaces [W/(m² K)], λ/(3 Ra + gap). It remains where a
/// seat comes loose. `gap`: between the mean planes, beyond the roughness; >= 0 [m].
[[nodiscard]] inline double gas_gap(double roughness, double gap,
                                    double conductivity = gap_conductivity) {
  return conductivity / (3.0 * roughness + std::max(gap, 0.0));
}

/// Conductance of a seat: spots and air in parallel [W/(m² K)]. Of `pressure` and `gap` one is
/// zero.
[[nodiscard]] inline double seat_conductance(const RoughContact& c, double pressure, double gap) {
  return solid_contact(c, pressure) + gas_gap(c.roughness, gap);
}

/// Resistance of a small elliptical contact between two half spaces [K/W].
///
///   R = K(k)/(2 π a) (1/λ1 + 1/λ2),   k² = 1 - b²/a²,   a >= b semi-axes
///
/// K is the complete elliptic integral of the first kind, of modulus k.
/// Source:   isothermal ellipse, from the capacity of an elliptic disc; circle 1/(4 λ a) each side.
/// Domain:   semi-axes in either order; infinite where one is zero.
[[nodiscard]] double constriction_resistance(double semi_axis, double other_semi_axis,
                                             double first_conductivity, double second_conductivity);

}  // namespace raceway::spindle
