#pragma once

#include "bearing/geometry.h"

namespace raceway::life {

/// Factors of the dynamic equivalent load of a single row [1]: P = F_r up to F_a/F_r = e, beyond it
/// X F_r + Y F_a.
struct LoadFactors {
  double X, Y, e;
};

/// Load factors of one bearing under an axial load [N].
///
///   up to 15 deg    by F_a/(Z D²), 0.172 to 6.89 N/mm²; the ends hold outside
///   from 20 deg     by the contact angle alone
///   between         linear, in the load first; 0 to 5 deg as a deep groove
///
/// The first column that catalogues use, f0 F_a/C0, is F_a/(Z D²) over cos α, since C0 = f0 Z D²
/// cos α: so no f0 is needed.
/// Source:   [ISO281, table 3], print not seen; every row was read in a transcript, and X + Y e = 1
///           within 1 % at all its points (tested), as P is continuous at e.
/// Domain:   α0 from 0 to 45 deg, F_a by magnitude; no number beyond.
/// Accuracy: as printed. Under preload or at speed the reference life (reference_life.h) is better.
[[nodiscard]] LoadFactors load_factors(const bearing::BearingGeometry& geometry, double axial_load);

/// Dynamic equivalent radial load P [N] of radial and axial load by magnitude [N].
[[nodiscard]] double equivalent_load(const LoadFactors& factors, double radial_load,
                                     double axial_load);

/// Basic rating life L10 = (C/P)³ in millions of revolutions [1]; infinite without load.
/// Source: [ISO281, eq. 3].
[[nodiscard]] double basic_rating_life(double load_rating, double equivalent_load);

}  // namespace raceway::life
