#pragma once

#include <algorithm>
#include <cmath>

#include "record/units.h"

/// Computes heat transfer between solid parts in contact.
namespace raceway::spindle {

/// Two rough surfaces pressed together.
struct RoughContact {
  double roughness = unset;            ///< Ra [m]
  double slope = unset;                ///< mean asperity slope m of the surfaces [1]
  double hardness = unset;             ///< hardness H of the softer surface [Pa]
  double first_conductivity = unset;   ///< λ1 [W/(m K)]
  double second_conductivity = unset;  ///< λ2 [W/(m K)]
};

/// Returns the thermal conductance of the contact spots of two rough surfaces [W/(m² K)].
///
///   1/h = 0.46 (Ra/m)(1/λ1 + 1/λ2)(p/H)^-0.93
///
/// h is the conductance, and p the pressure; RoughContact defines the other symbols.
/// Source:   [Brecher2021, eq. 4], with Ra in m.
/// Domain:   p/H below about 0.02; the result is zero for a pressure p <= 0.
/// Accuracy: within 3 % of yovanovich_contact() from 1 to 10 MPa; measured conductances of seats
///           differ from the formula by a factor of up to 2.
[[nodiscard]] inline double solid_contact(const RoughContact& c, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  return std::pow(pressure / c.hardness, 0.93) * c.slope /
         (0.46 * c.roughness * (1.0 / c.first_conductivity + 1.0 / c.second_conductivity));
}

/// Returns the thermal conductance of the contact spots by Yovanovich's formula [W/(m² K)].
///
///   h = 1.25 (2 λ1 λ2/(λ1 + λ2)) (m/Ra) (p/H)^0.95
///
/// RoughContact defines λ1, λ2, m, Ra and H. p is the pressure.
/// Source:   Yovanovich's fit to Cooper, Mikic and Yovanovich (Int J Heat Mass Transfer 12, 1969,
///           p. 279). The formula in the 1969 paper has the factor 1.45 and the exponent 0.985.
///           yovanovich_contact() uses Ra in place of the rms roughness.
/// Domain:   p/H below about 0.02; the result is zero for a pressure p <= 0.
[[nodiscard]] inline double yovanovich_contact(const RoughContact& c, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  const double mean = 2.0 * c.first_conductivity * c.second_conductivity /
                      (c.first_conductivity + c.second_conductivity);
  return 1.25 * mean * c.slope / c.roughness * std::pow(pressure / c.hardness, 0.95);
}

/// Thermal conductivity λ of the air in gaps of seats [W/(m K)].
inline constexpr double gap_conductivity = 0.027;

/// Returns the thermal conductance λ/(3 Ra + gap) of the air between rough surfaces [W/(m² K)]. A
/// loose seat has only this conductance. `gap` is the gap in addition to the roughness, >= 0 [m].
[[nodiscard]] inline double gas_gap(double roughness, double gap,
                                    double conductivity = gap_conductivity) {
  return conductivity / (3.0 * roughness + std::max(gap, 0.0));
}

/// Returns the thermal conductance of a seat [W/(m² K)], with contact spots and air gap in
/// parallel. For a tight seat, `gap` is 0; for a loose seat, `pressure` is 0.
[[nodiscard]] inline double seat_conductance(const RoughContact& c, double pressure, double gap) {
  return solid_contact(c, pressure) + gas_gap(c.roughness, gap);
}

/// Returns the thermal constriction resistance of a small elliptical contact between two large
/// bodies [K/W].
///
///   R = K(k)/(2 π a) (1/λ1 + 1/λ2),   k² = 1 - b²/a²,   a >= b semi-axes
///
/// K is the complete elliptic integral of the first kind with modulus k.
/// Source:   derived for an isothermal contact ellipse from the electrical capacitance of an
///           elliptic disc. For a circle of radius a, each body has the resistance 1/(4 λ a).
/// Domain:   semi-axes in either order; the result is infinite if one semi-axis is zero.
[[nodiscard]] double constriction_resistance(double semi_axis, double other_semi_axis,
                                             double first_conductivity, double second_conductivity);

}  // namespace raceway::spindle
