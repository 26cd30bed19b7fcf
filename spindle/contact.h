#pragma once

#include <algorithm>
#include <cmath>

#include "record/units.h"

/// Computes heat transfer between solids in contact.
namespace raceway::spindle {

/// Two rough surfaces pressed together.
struct RoughContact {
  double roughness = unset;            ///< Ra [m]
  double slope = unset;                ///< mean asperity slope m of the surfaces [1]
  double hardness = unset;             ///< hardness H of the softer surface [Pa]
  double first_conductivity = unset;   ///< λ1 [W/(m K)]
  double second_conductivity = unset;  ///< λ2 [W/(m K)]
};

/// Returns the conductance of the contact spots [W/(m² K)].
///
///   1/h = 0.46 (Ra/m)(1/λ1 + 1/λ2)(p/H)^-0.93
///
/// Source:   [Brecher2021, eq. 4], with Ra in m.
/// Domain:   p/H below about 0.02; zero for p <= 0.
/// Accuracy: within 3 % of yovanovich_contact() from 1 to 10 MPa; real seats differ by a factor of
///           2.
[[nodiscard]] inline double solid_contact(const RoughContact& c, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  return std::pow(pressure / c.hardness, 0.93) * c.slope /
         (0.46 * c.roughness * (1.0 / c.first_conductivity + 1.0 / c.second_conductivity));
}

/// Returns the conductance of a rough contact by Yovanovich [W/(m² K)].
///
///   h = 1.25 (2 λ1 λ2/(λ1 + λ2)) (m/Ra) (p/H)^0.95
///
/// Source:   Yovanovich's fit to Cooper, Mikic and Yovanovich (Int J Heat Mass Transfer 12, 1969,
///           p. 279), whose own formula has the factor 1.45 and the exponent 0.985. Ra replaces the
///           rms roughness.
/// Domain:   as for solid_contact().
[[nodiscard]] inline double yovanovich_contact(const RoughContact& c, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  const double mean = 2.0 * c.first_conductivity * c.second_conductivity /
                      (c.first_conductivity + c.second_conductivity);
  return 1.25 * mean * c.slope / c.roughness * std::pow(pressure / c.hardness, 0.95);
}

/// Thermal conductivity λ of the air in gaps of seats [W/(m K)].
inline constexpr double gap_conductivity = 0.027;

/// Returns the conductance of the air between rough surfaces [W/(m² K)], λ/(3 Ra + gap). This
/// conductance remains when a seat becomes loose. `gap` is the distance of the mean planes minus
/// the roughness, >= 0 [m].
[[nodiscard]] inline double gas_gap(double roughness, double gap,
                                    double conductivity = gap_conductivity) {
  return conductivity / (3.0 * roughness + std::max(gap, 0.0));
}

/// Returns the conductance of a seat: contact spots and air in parallel [W/(m² K)]. Either
/// `pressure` or `gap` is zero.
[[nodiscard]] inline double seat_conductance(const RoughContact& c, double pressure, double gap) {
  return solid_contact(c, pressure) + gas_gap(c.roughness, gap);
}

/// Returns the constriction resistance of a small elliptical contact between two half spaces [K/W].
///
///   R = K(k)/(2 π a) (1/λ1 + 1/λ2),   k² = 1 - b²/a²,   a >= b semi-axes
///
/// K is the complete elliptic integral of the first kind with modulus k.
/// Source:   isothermal ellipse, from the capacitance of an elliptic disc; a circle has 1/(4 λ a)
///           on each side.
/// Domain:   semi-axes in either order; infinite if one is zero.
[[nodiscard]] double constriction_resistance(double semi_axis, double other_semi_axis,
                                             double first_conductivity, double second_conductivity);

}  // namespace raceway::spindle
