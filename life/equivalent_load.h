#pragma once

#include "bearing/geometry.h"

namespace raceway::life {

/// Factors of the dynamic equivalent load P of a single-row bearing [1]: P = F_r up to F_a/F_r = e,
/// and P = X F_r + Y F_a above e. F_r and F_a are the radial and axial load.
struct LoadFactors {
  double X, Y, e;
};

/// Load factors of one bearing under an axial load F_a [N], by ranges of the nominal contact angle:
///
///   0 to 5 deg      values of deep groove bearings, a function of F_a/(Z D²)
///   10, 15 deg      function of F_a/(Z D²), tabulated from 0.172 to 6.89 N/mm²
///   from 20 deg     function of the contact angle only
///
/// Between the stated angles (5, 10, 15 and 20 deg), the factors are interpolated linearly in the
/// angle. If F_a/(Z D²) is outside the table, the function uses the factors at the nearer end of
/// the table. Z is the number of balls, and D is the ball diameter. Catalogues use the ratio f0
/// F_a/C0 instead of F_a/(Z D²). C0 is the static load rating, f0 a factor from the catalogue, and
/// α the contact angle. Because C0 = f0 Z D² cos α, the two ratios differ by the factor cos α,
/// which is at least 0.966 up to 15 deg.
/// Source:   [ISO281, table 3], from a transcript, not checked against the printed standard. In
///           every row of the table, X + Y e = 1 within 1 %, so P is nearly continuous at F_a/F_r =
///           e.
/// Domain:   contact angle from 0 to 45 deg; the factors are NaN above 45 deg. The function uses
///           the magnitude of F_a.
/// Accuracy: as accurate as the published table. For a preloaded bearing or at high speed,
///           reference_life() is more accurate.
[[nodiscard]] LoadFactors load_factors(const bearing::BearingGeometry& geometry, double axial_load);

/// Dynamic equivalent radial load P from the magnitudes of radial and axial load [N].
[[nodiscard]] double equivalent_load(const LoadFactors& factors, double radial_load,
                                     double axial_load);

/// Basic rating life L10 = (C/P)³ in millions of revolutions [1]; infinite without load.
/// Source: [ISO281, eq. 3].
[[nodiscard]] double basic_rating_life(double load_rating, double equivalent_load);

}  // namespace raceway::life
