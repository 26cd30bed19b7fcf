#pragma once

#include <cmath>

#include "friction/contact/film.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Oil supply of the contact inlets: flooded, or limited to the oil that the preceding ball leaves.
enum class Inlet { flooded, limited };

/// Inlet and ellipse of a loaded contact, as input of rolling_force().
struct RollingEllipse {
  RollingInlet inlet;
  double radius_across = unset;    ///< R_z, equivalent radius across rolling [m]
  double semi_major_axis = unset;  ///< a, across rolling [m]
  double semi_minor_axis = unset;  ///< b, along rolling [m]
  double second_integral = unset;  ///< E(k), HertzContact::second_integral [1]
};

/// Moes' load parameter M of a contact ellipse [1]. If M is above about 10, the contact is
/// elastohydrodynamic. If M is much smaller, the contact is rigid and isoviscous.
///
///   M = β^0.25 κ W/U^0.75,   β = (4/π) E(k)/(1 + R_x/R_z),   κ = b/a,
///   U = 2 η u/(E' R_x),   W = Q/(E' R_x²)
///
/// RollingEllipse and RollingInlet describe the other symbols.
[[nodiscard]] inline double moes_load(const RollingEllipse& c) {
  const RollingInlet& i = c.inlet;
  const double U = 2.0 * i.viscosity * i.speed / (i.modulus * i.radius_along);
  const double W = i.load / (i.modulus * i.radius_along * i.radius_along);
  const double beta = 4.0 / pi * c.second_integral / (1.0 + i.radius_along / c.radius_across);
  return std::pow(beta, 0.25) * (c.semi_minor_axis / c.semi_major_axis) * W / std::pow(U, 0.75);
}

/// Rolling resistance of the oil in the inlet of a contact, on each of the two surfaces [N].
///
///   F = E' R_x² ((IVR - EHL)/(1 + M/6.6) + EHL)
///   flooded   IVR = 0.77 β^(-1/3) κ^0.12 (2a/R_x) U^(2/3),  EHL = 1.8 β^(-1/4) (2a/R_x) U^(3/4)
///   limited   IVR = 0.835 (R_x/R_z)^-0.358 U^0.636 W^0.364,
///             EHL = 1.544 β^(1/3) κ^-0.577 U^0.656 W^0.466 G^0.022
///
/// IVR is the force of a rigid contact with isoviscous oil, and EHL the force of an
/// elastohydrodynamic contact, both divided by E' R_x². U, W, β, κ and M are defined at
/// moes_load(), and G = α E'. rolling_power() computes the power loss from F.
/// Source:   [BibouletHoupert2010, part 2, eqs. 28 to 32]. Houpert published the formula for
///           limited inlets in 1987. [Balan2015, eqs. 1 to 5] gives the same formulas. The
///           equations were read from a plain-text copy of the paper and not compared with the
///           printed pages.
/// Domain:   Q > 0. The force is zero at standstill, where its derivative with respect to speed is
///           infinite.
/// Accuracy: the code agrees with the formula to rounding error. At spindle speeds, the forces for
///           flooded and limited inlets differ by 30 to 55 %, and the inlet condition is not known
///           beforehand.
/// Trap:     U here is twice the U of isothermal_film().
[[nodiscard]] inline double rolling_force(const RollingEllipse& c, Inlet supply) {
  const RollingInlet& i = c.inlet;
  if (!(i.speed > 0.0 && i.load > 0.0)) return 0.0;
  const double area = i.modulus * i.radius_along * i.radius_along;
  const double U = 2.0 * i.viscosity * i.speed / (i.modulus * i.radius_along);
  const double W = i.load / area;
  const double ratio = i.radius_along / c.radius_across;
  const double beta = 4.0 / pi * c.second_integral / (1.0 + ratio);
  const double kappa = c.semi_minor_axis / c.semi_major_axis;
  double rigid, elastic;
  if (supply == Inlet::flooded) {
    const double width = 2.0 * c.semi_major_axis / i.radius_along;
    rigid = 0.77 / std::cbrt(beta) * std::pow(kappa, 0.12) * width * std::cbrt(U * U);
    elastic = 1.8 * std::pow(beta, -0.25) * width * std::pow(U, 0.75);
  } else {
    const double G = i.pressure_viscosity * i.modulus;
    rigid = 0.835 * std::pow(ratio, -0.358) * std::pow(U, 0.636) * std::pow(W, 0.364);
    elastic = 1.544 * std::cbrt(beta) * std::pow(kappa, -0.577) * std::pow(U, 0.656) *
              std::pow(W, 0.466) * std::pow(G, 0.022);
  }
  return area * ((rigid - elastic) / (1.0 + moes_load(c) / 6.6) + elastic);
}

/// Power lost in the oil of one inlet, P = 2 F u [W]. The factor 2 arises because the rolling force
/// F acts on both surfaces. u is the mean surface speed.
///
/// Source:   derived from the power integral of [BibouletHoupert2010, part 2, eq. 37]. The formula
///           agrees with the moment 6 r F of [Balan2015] for three balls between two plates, where
///           r is the radius of the ball track.
[[nodiscard]] inline double rolling_power(double force, double speed) {
  return 2.0 * force * speed;
}

/// Factor on the rolling force that accounts for inlet shear heating [1].
///
///   φ = 1/(1 + 0.29 L^0.78),   L = thermal_loading()
///
/// Source:   [Aihara1987], on tapered rollers, as quoted in a published report; not checked against
///           the paper.
/// Domain:   L >= 0; φ = 1 at L = 0. The measurements of the source reach about L = 5. Spindle
///           bearings reach L = 10, where the formula is extrapolated and reduces the rolling force
///           by nearly two thirds.
/// Trap:     above about L = 40 for limited inlets and L = 300 for flooded inlets, the product of φ
///           and the rolling force decreases when the viscosity increases. Such values of L occur
///           with thick oil at the highest speeds, where there are no measurements.
[[nodiscard]] inline double thermal_rolling_factor(double loading) {
  if (!(loading > 0.0)) return 1.0;
  return 1.0 / (1.0 + 0.29 * std::pow(loading, 0.78));
}

}  // namespace raceway::friction::contact
