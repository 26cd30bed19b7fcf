#pragma once

#include "bearing/roller_equilibrium.h"

namespace raceway::life {

/// Factor f_c of the dynamic rating of radial roller bearings [1].
///
///   f_c = 207.9 · 0.83 γ^(2/9) (1-γ)^(29/27)/(1+γ)^(1/4) (1 + (1.04 r)^4.5)^(-2/9)
///   r = ((1-γ)/(1+γ))^(143/108),   γ = D/d_m (roller diameter over pitch diameter)
///
/// Source: [ISO281], not checked against the printed standard. The formula agrees with six values
///         of the published table within 0.1 %.
[[nodiscard]] double roller_rating_factor(double diameter_ratio);

/// Dynamic load rating C = 1.1 f_c L^(7/9) Z^(3/4) D^(29/27) [N]. Z is the number of rollers. The
/// effective roller length L and the roller diameter D are in mm in this formula. f_c comes from
/// roller_rating_factor(). Source: [ISO281], not checked against the printed standard.
/// Accuracy: the code agrees with the formula to rounding error. Makers define the effective length
///           differently, so load ratings in catalogues differ.
[[nodiscard]] double dynamic_load_rating(const bearing::RollerGeometry& geometry);

/// Static load rating C0 [N]: the value in `geometry` if it is given, otherwise 44 (1 - γ) Z L D. Z
/// is the number of rollers, L the roller length and D the roller diameter [mm], and γ = D/d_m.
/// Source: [ISO76], not checked against the printed standard.
[[nodiscard]] double static_load_rating(const bearing::RollerGeometry& geometry);

/// Fatigue load limit C_u = C0/8.2 [N]. If the pitch diameter d_m is above 100 mm, C_u is C0/8.2
/// (100 mm/d_m)^0.3. Source: [ISO281], not checked against the printed standard.
[[nodiscard]] double fatigue_load(const bearing::RollerGeometry& geometry);

/// Dynamic load ratings of the races [N]: roller loads at the inner race (Q_ci) and the outer race
/// (Q_ce) for a basic rating life of a million revolutions. Z is the number of rollers, and C is
/// the dynamic load rating of the bearing.
///
///   Q_ci = C/(0.83 · 0.378 Z) (1 + T^4.5)^(2/9),   Q_ce = C/(0.83 · 0.364 Z) (1 + T^-4.5)^(2/9)
///   T = 1.038 r, with r of roller_rating_factor()
///
/// Source: [ISO16281], as an open-source program implements it, not checked against the printed
///         standard.
struct RollerRatings {
  double inner = unset, outer = unset;
};
[[nodiscard]] RollerRatings race_ratings(const bearing::RollerGeometry& geometry,
                                         double load_rating);

/// Edge stress factor of one slice of a roller [1]. `lamina` is the number of the slice along the
/// roller, from 0 to 40.
///
///   1 - 0.01/ln(1.985 |2k - ns - 1|/(2 ns - 2)),  k = lamina + 1, ns = 41;  1 for the middle slice
///
/// Source: [ISO16281], as an open-source program implements it for the inner ring. The
///         function uses this factor for both rings, because that program has a wrong factor for
///         the outer ring.
[[nodiscard]] double edge_factor(std::size_t lamina);

/// Reference rating life L10r from the loads of all slices of the rollers, in millions of
/// revolutions [1].
///
///   L10r = (Σ ((q_i/q_ci)^4.5 + (q_e/q_ce)^4.5))^(-8/9),   q_c = Q_c ns^(-7/9)
///
/// The sum is over the ns = 41 slices. q_i and q_e are power means of the slice load over all
/// rollers: q_i for the rotating inner ring with exponent 4, q_e for the outer ring with exponent
/// 4.5. q_ci and q_ce are the ratings q_c of a slice, from the race ratings Q_c. If `edges` is
/// true, the load of each slice is multiplied by edge_factor().
/// Source:   [ISO16281].
/// Domain:   the life is NaN if the equilibrium did not converge, and infinite if there is no load.
/// Trap:     for rollers without a profile, the edge stress makes the life depend on the number of
///           slices. L10r differs from the basic rating life (C/F_r)^(10/3): with the roller
///           profile of the standard and C/F_r = 20.7, L10r is 3.3 times the basic rating life.
[[nodiscard]] double reference_life(const RollerRatings& ratings,
                                    const bearing::RollerEquilibrium& equilibrium,
                                    bool edges = true);

/// Returns the load P_ref whose basic rating life by ISO 281 equals the reference rating life:
/// P_ref = C/L10r^0.3 [N].
[[nodiscard]] double roller_reference_load(double load_rating, double reference_life);

/// Basic rating life (C/P)^(10/3), in millions of revolutions [1].
[[nodiscard]] double roller_rating_life(double load_rating, double load);

/// Static safety factor (4000 MPa/p)² [1] from the largest contact pressure p; infinite at p = 0.
/// The pressure of a line contact is proportional to the square root of the load. Source: [ISO76].
[[nodiscard]] double roller_static_safety(double peak_pressure);

}  // namespace raceway::life
