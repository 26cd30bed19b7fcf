#pragma once

#include "bearing/balls.h"
#include "bearing/bearing.h"

namespace raceway::life {

/// Dynamic load ratings of the races [N]: ball loads at the inner race (Q_ci) and the outer race
/// (Q_ce) for a basic rating life of a million revolutions.
///
///   Q_ci = C/(0.407 Z cos α) (1 + T^(10/3))^0.3,   Q_ce = C/(0.389 Z cos α) (1 + T^(-10/3))^0.3
///   T = 1.044 ((1 - γ)/(1 + γ))^1.72 (f_i (2 f_o - 1)/(f_o (2 f_i - 1)))^0.41,  γ = D cos α/d_m
///
/// C is the dynamic load rating of the bearing, Z the number of balls and α the nominal contact
/// angle. D is the ball diameter and d_m the pitch diameter. f_i and f_o are the conformities of
/// inner and outer ring.
/// Source:   [ISO16281, eqs. 1, 2], as two other programs implement them, not checked against the
///           printed standard. In this code, the exponent of cos α is 1. One of the two programs
///           has the exponent 0.7, which changes the result only if α is not 0.
/// Domain:   α from 0 to 45 deg; the ratings are NaN above 45 deg. C comes from
///           dynamic_load_rating() or from a catalogue [N].
struct RaceRatings {
  double inner = unset, outer = unset;
};
[[nodiscard]] RaceRatings race_ratings(const bearing::BearingGeometry& geometry,
                                       double load_rating);

/// Reference rating life L10r from the loads Q of all Z balls, in millions of revolutions [1].
///
///   L10r = ((Q_ci/Q_ei)^(-10/3) + (Q_ce/Q_ee)^(-10/3))^-0.9
///   Q_ei = (Σ Q³/Z)^(1/3) (rotating inner ring),   Q_ee = (Σ Q^(10/3)/Z)^0.3 (outer ring)
///
/// Source:   [ISO16281, eqs. 5 to 9]. For a deep-groove bearing, the lives differ by at most 0.03 %
///           from the results of a commercial program.
/// Domain:   the inner ring rotates. The life is NaN if a load is NaN, and infinite without load.
///           At high speed, the loads of a ball on inner and outer race differ, and the function
///           uses the loads on each race. The standard does not cover high speed.
/// Accuracy: the code agrees with the formula to rounding error. ISO 281 has no formula for hybrid
///           bearings. For hybrid bearings, the function uses the formula for steel with the ball
///           loads of the hybrid bearing, as makers do.
[[nodiscard]] double reference_life(const RaceRatings& ratings, const bearing::Balls& balls);

/// Reference rating life from the equivalent ball loads Q_ei (`inner_mean`) and Q_ee (`outer_mean`)
/// [N], in millions of revolutions [1].
[[nodiscard]] double reference_life(const RaceRatings& ratings, double inner_mean,
                                    double outer_mean);

/// Returns the load P_ref whose basic rating life by ISO 281 equals the reference rating life:
/// P_ref = C/L10r^(1/3) [N].
/// Source: [ISO16281, eq. 11].
[[nodiscard]] double reference_load(double load_rating, double reference_life);

/// Static safety factor of a contact from its largest pressure p_max [1]: permissible contact load
/// divided by actual contact load.
///
///   s = (4200 MPa/p_max)³
///
/// Source:   basis of [ISO76]: a pressure of 4200 MPa causes a permanent dent of 1e-4 of the ball
///           diameter. The pressure is proportional to the cube root of the load. The limit is a
///           pressure, so the formula also applies to hybrid bearings. Makers use a higher limit
///           for hybrid bearings.
/// Domain:   p_max > 0; s is infinite at p_max = 0.
[[nodiscard]] double static_safety(double peak_pressure);

}  // namespace raceway::life
