#pragma once

#include "bearing/roller_equilibrium.h"

namespace raceway::life {

/// f_c of radial roller bearings [1].
///
///   f_c = 207.9 · 0.83 γ^(2/9) (1-γ)^(29/27)/(1+γ)^(1/4) (1 + (1.04 r)^4.5)^(-2/9)
///   r = ((1-γ)/(1+γ))^(143/108),   γ = D/d_m
///
/// Source: [ISO281], from memory; meets six values of the printed table to 0.1 %.
[[nodiscard]] double roller_rating_factor(double diameter_ratio);

/// C = 1.1 f_c L^(7/9) Z^(3/4) D^(29/27) [N; mm]. Source: [ISO281], from memory.
/// Accuracy: the formula; effective lengths of makers differ, and so do their C.
[[nodiscard]] double dynamic_load_rating(const bearing::RollerGeometry& geometry);

/// C0 = 44 (1 - γ) Z L D [N; mm], or what the geometry gives. Source: [ISO76], from memory.
[[nodiscard]] double static_load_rating(const bearing::RollerGeometry& geometry);

/// C_u = C0/8.2, above d_m = 100 mm times (100 mm/d_m)^0.3 [N]. Source: [ISO281], from memory.
[[nodiscard]] double fatigue_load(const bearing::RollerGeometry& geometry);

/// Loads of a roller that each race carries for a million revolutions [N].
///
///   Q_ci = C/(0.83 · 0.378 Z) (1 + T^4.5)^(2/9),   Q_ce = C/(0.83 · 0.364 Z) (1 + T^-4.5)^(2/9)
///   T = 1.038 r
///
/// Source: [ISO16281], print not seen; read in an open program.
struct RollerRatings {
  double inner = unset, outer = unset;
};
[[nodiscard]] RollerRatings race_ratings(const bearing::RollerGeometry& geometry,
                                         double load_rating);

/// Stress concentration of slice k = 0 ... 40 that stands for the edge [1].
///
///   1 - 0.01/ln(1.985 |2k - ns - 1|/(2 ns - 2)),  k from 1;  1 in the middle
///
/// Source: [ISO16281], read in an open program, whose factor of the outer ring is spoilt.
[[nodiscard]] double edge_factor(std::size_t lamina);

/// Reference rating life from the loads of all slices, in millions of revolutions [1].
///
///   L10r = (Σ (q_i/q_ci)^4.5 + (q_e/q_ce)^4.5)^(-8/9),   q_c = Q_c ns^(-7/9)
///
/// q_i: mean over the rollers with exponent 4 (the inner ring turns), q_e with 4.5; each slice
/// times its edge_factor() where `edges`.
/// Source:   [ISO16281].
/// Domain:   an equilibrium, else NaN; infinite if nothing is loaded.
/// Trap:     without a profile it hangs on the number of slices, through the edges. L10r is not
///           (C/F_r)^(10/3): at C/F_r = 20.7 it is 3.3 times longer with the profile.
[[nodiscard]] double reference_life(const RollerRatings& ratings,
                                    const bearing::RollerEquilibrium& equilibrium,
                                    bool edges = true);

/// P_ref = C/L10r^0.3 [N]: the load of which ISO 281 would make that life.
[[nodiscard]] double roller_reference_load(double load_rating, double reference_life);

/// (C/P)^(10/3), in millions of revolutions [1].
[[nodiscard]] double roller_rating_life(double load_rating, double load);

/// (4000 MPa/p)² [1]; infinite at 0. Source: [ISO76]: pressure grows with the root of the load.
[[nodiscard]] double roller_static_safety(double peak_pressure);

}  // namespace raceway::life
