#pragma once

#include "bearing/balls.h"
#include "bearing/bearing.h"

namespace raceway::life {

/// Dynamic ball load ratings of the races, for a million revolutions [N].
///
///   Q_ci = C/(0.407 Z cos α) (1 + T^(10/3))^0.3,   Q_ce = C/(0.389 Z cos α) (1 + T^(-10/3))^0.3
///   T = 1.044 ((1 - γ)/(1 + γ))^1.72 (f_i (2 f_o - 1)/(f_o (2 f_i - 1)))^0.41,  γ = D cos α/d_m
///
/// Source:   [ISO16281, eqs. 1, 2], print not seen; read in two programs. cos α to the first power:
///           one of them has 0.7, which shows only where α is not 0.
/// Domain:   α nominal, from 0 to 45 deg; C of dynamic_load_rating() or of a catalogue [N].
struct RaceRatings {
  double inner = unset, outer = unset;
};
[[nodiscard]] RaceRatings race_ratings(const bearing::BearingGeometry& geometry,
                                       double load_rating);

/// Reference rating life from the loads of all balls, in millions of revolutions [1].
///
///   L10r = ((Q_ci/Q_ei)^(-10/3) + (Q_ce/Q_ee)^(-10/3))^-0.9
///   Q_ei = (Σ Q³/Z)^(1/3) on the turning inner ring,   Q_ee = (Σ Q^(10/3)/Z)^0.3 on the outer one
///
/// Source:   [ISO16281, eqs. 5 to 9]. All lives that a commercial program prints for a deep-groove
///           bearing are met within 3e-4.
/// Domain:   inner ring turning; NaN where a load is. Infinite where nothing is loaded. At speed
///           the loads of either race apply to that race; the standard does not cover speed.
/// Accuracy: the formula to rounding. For hybrid bearings it is the formula of steel on their own
///           ball loads, as their makers do it; ISO 281 has none for them.
[[nodiscard]] double reference_life(const RaceRatings& ratings, const bearing::Balls& balls);

/// Reference life from loads that are already summed up, Q_ei and Q_ee [N].
[[nodiscard]] double reference_life(const RaceRatings& ratings, double inner_mean,
                                    double outer_mean);

/// Returns the load of this life by ISO 281, P_ref = C/L10r^(1/3) [N].
/// Source: [ISO16281, eq. 11].
[[nodiscard]] double reference_load(double load_rating, double reference_life);

/// Static safety factor of a contact from its largest pressure, by load [1].
///
///   s = (4200 MPa/p_max)³
///
/// Source:   basis of [ISO76]: a dent of 1e-4 D at 4200 MPa; pressure grows with the cube root of
///           load. By stress, so it holds for hybrid bearings too, whose limit makers put higher.
/// Domain:   p_max > 0; infinite at 0.
[[nodiscard]] double static_safety(double peak_pressure);

}  // namespace raceway::life
