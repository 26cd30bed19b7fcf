#pragma once

#include "bearing/roller_equilibrium.h"

namespace raceway::life {

/// Factor f_c of the dynamic rating of radial roller bearings [1].
///
///   f_c = 207.9 · 0.83 γ^(2/9) (1-γ)^(29/27)/(1+γ)^(1/4) (1 + (1.04 r)^4.5)^(-2/9)
///   r = ((1-γ)/(1+γ))^(143/108),   γ = D/d_m
///
/// Source: [ISO281], quoted from memory. The formula agrees with six values of the published table
///         to 0.1 %.
[[nodiscard]] double roller_rating_factor(double diameter_ratio);

/// Dynamic load rating C = 1.1 f_c L^(7/9) Z^(3/4) D^(29/27) [N], with the effective length L and
/// the diameter D of the Z rollers in mm. Source: [ISO281], quoted from memory.
/// Accuracy: the code agrees with the formula to rounding error. Makers define the effective length
///           differently, so the load rating C of makers differs.
[[nodiscard]] double dynamic_load_rating(const bearing::RollerGeometry& geometry);

/// Static load rating C0 of the geometry if it is given, else 44 (1 - γ) Z L D [N], with L and D in
/// mm. Source: [ISO76], quoted from memory.
[[nodiscard]] double static_load_rating(const bearing::RollerGeometry& geometry);

/// Fatigue load limit C_u = C0/8.2 [N]; above d_m = 100 mm, multiplied by (100 mm/d_m)^0.3. Source:
/// [ISO281], quoted from memory.
[[nodiscard]] double fatigue_load(const bearing::RollerGeometry& geometry);

/// Dynamic roller load ratings of the races, for a million revolutions [N].
///
///   Q_ci = C/(0.83 · 0.378 Z) (1 + T^4.5)^(2/9),   Q_ce = C/(0.83 · 0.364 Z) (1 + T^-4.5)^(2/9)
///   T = 1.038 r, with r of roller_rating_factor()
///
/// Source: [ISO16281], as an open-source program implements it, not checked against the print.
struct RollerRatings {
  double inner = unset, outer = unset;
};
[[nodiscard]] RollerRatings race_ratings(const bearing::RollerGeometry& geometry,
                                         double load_rating);

/// Edge stress factor of slice `lamina` = 0 ... 40 [1].
///
///   1 - 0.01/ln(1.985 |2k - ns - 1|/(2 ns - 2)),  k = lamina + 1, ns = 41;  1 in the middle
///
/// Source: [ISO16281], as an open-source program implements it. The program has a wrong factor for
///         the outer ring.
[[nodiscard]] double edge_factor(std::size_t lamina);

/// Reference rating life from the loads of all slices, in millions of revolutions [1].
///
///   L10r = (Σ (q_i/q_ci)^4.5 + (q_e/q_ce)^4.5)^(-8/9),   q_c = Q_c ns^(-7/9)
///
/// q_i and q_e are power means of the slice load over the rollers: q_i with exponent 4, because the
/// inner ring rotates, and q_e with exponent 4.5. If `edges` is true, the loads of each slice are
/// multiplied by its edge_factor().
/// Source:   [ISO16281].
/// Domain:   the life is NaN without a converged equilibrium, and infinite without load.
/// Trap:     without a roller profile, the edge stress makes the life depend on the number of
///           slices. L10r differs from (C/F_r)^(10/3): with the ISO profile and C/F_r = 20.7, L10r
///           is 3.3 times as long.
[[nodiscard]] double reference_life(const RollerRatings& ratings,
                                    const bearing::RollerEquilibrium& equilibrium,
                                    bool edges = true);

/// Returns the load whose basic rating life by ISO 281 equals the reference life, P_ref =
/// C/L10r^0.3 [N].
[[nodiscard]] double roller_reference_load(double load_rating, double reference_life);

/// Basic rating life (C/P)^(10/3), in millions of revolutions [1].
[[nodiscard]] double roller_rating_life(double load_rating, double load);

/// Static safety factor (4000 MPa/p)² [1]; infinite at p = 0. Source: [ISO76]; the pressure is
/// proportional to the square root of the load.
[[nodiscard]] double roller_static_safety(double peak_pressure);

}  // namespace raceway::life
