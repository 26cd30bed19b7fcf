#pragma once

#include "bearing/balls.h"
#include "bearing/bearing.h"

namespace raceway::life {

/// Dynamic ball load ratings of the races, for a million revolutions [N].
///
///   Q_ci = C/(0.407 Z cos α) (1 + T^(10/3))^0.3,   Q_ce = C/(0.389 Z cos α) (1 + T^(-10/3))^0.3
///   T = 1.044 ((1 - γ)/(1 + γ))^1.72 (f_i (2 f_o - 1)/(f_o (2 f_i - 1)))^0.41,  γ = D cos α/d_m
///
/// α is the nominal contact angle. f_i and f_o are the conformities of inner and outer ring.
/// Source:   [ISO16281, eqs. 1, 2], as two other programs implement them, not checked against the
///           print. The exponent of cos α is 1 here; one of the programs has 0.7, which matters
///           only if α is not 0.
/// Domain:   nominal α from 0 to 45 deg, NaN above; C from dynamic_load_rating() or from a
///           catalogue [N].
struct RaceRatings {
  double inner = unset, outer = unset;
};
[[nodiscard]] RaceRatings race_ratings(const bearing::BearingGeometry& geometry,
                                       double load_rating);

/// Reference rating life from the loads of all balls, in millions of revolutions [1].
///
///   L10r = ((Q_ci/Q_ei)^(-10/3) + (Q_ce/Q_ee)^(-10/3))^-0.9
///   Q_ei = (Σ Q³/Z)^(1/3) (rotating inner ring),   Q_ee = (Σ Q^(10/3)/Z)^0.3 (outer ring)
///
/// Source:   [ISO16281, eqs. 5 to 9]. The lives agree within 3e-4 with all lives that a commercial
///           program prints for a deep-groove bearing.
/// Domain:   the inner ring rotates. The life is NaN if a load is NaN, and infinite without load.
///           At speed, inner and outer ball loads differ, and each race uses its own loads; the
///           standard does not cover this effect of speed.
/// Accuracy: the code agrees with the formula to rounding error. For hybrid bearings, the formula
///           for steel is used with the ball loads of the hybrid bearing, as makers do. ISO 281 has
///           no formula for hybrid bearings.
[[nodiscard]] double reference_life(const RaceRatings& ratings, const bearing::Balls& balls);

/// Reference rating life from the equivalent loads Q_ei and Q_ee [N], in millions of revolutions
/// [1].
[[nodiscard]] double reference_life(const RaceRatings& ratings, double inner_mean,
                                    double outer_mean);

/// Returns the load whose basic rating life by ISO 281 equals the reference life, P_ref =
/// C/L10r^(1/3) [N].
/// Source: [ISO16281, eq. 11].
[[nodiscard]] double reference_load(double load_rating, double reference_life);

/// Static safety factor of a contact from its largest pressure, as a ratio of loads [1].
///
///   s = (4200 MPa/p_max)³
///
/// Source:   basis of [ISO76]: a dent of 1e-4 D at 4200 MPa. The pressure is proportional to the
///           cube root of the load. The limit is a pressure, so the formula also applies to hybrid
///           bearings. Makers use a higher limit for hybrid bearings.
/// Domain:   p_max > 0; s is infinite at p_max = 0.
[[nodiscard]] double static_safety(double peak_pressure);

}  // namespace raceway::life
