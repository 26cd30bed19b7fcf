#pragma once

#include "bearing/geometry.h"

namespace raceway::life {

/// Factors of the dynamic equivalent load of a single row [1]: P = F_r up to F_a/F_r = e, and P = X
/// F_r + Y F_a above e.
struct LoadFactors {
  double X, Y, e;
};

/// Load factors of one bearing under an axial load [N].
///
///   0 to 5 deg      values of deep groove bearings, a function of F_a/(Z D²)
///   10, 15 deg      function of F_a/(Z D²), tabulated from 0.172 to 6.89 N/mm², constant outside
///   from 20 deg     function of the contact angle only
///
/// Between these angles, the factors are linear in the angle. Z is the number of balls, and D is
/// the ball diameter. Catalogues use the ratio f0 F_a/C0 instead of F_a/(Z D²). Because C0 = f0 Z
/// D² cos α, the two ratios differ only by the factor cos α, at least 0.966 up to 15 deg.
/// Source:   [ISO281, table 3], not checked against the print. All rows of the table
///           come from a transcript. In every row, X + Y e = 1 within 1 % (tested), because P is
///           continuous at e.
/// Domain:   α0 from 0 to 45 deg, NaN above. The function uses the magnitude of F_a.
/// Accuracy: as accurate as the published table. Under preload or at speed, reference_life() is
///           more accurate.
[[nodiscard]] LoadFactors load_factors(const bearing::BearingGeometry& geometry, double axial_load);

/// Dynamic equivalent radial load P from the magnitudes of radial and axial load [N].
[[nodiscard]] double equivalent_load(const LoadFactors& factors, double radial_load,
                                     double axial_load);

/// Basic rating life L10 = (C/P)³ in millions of revolutions [1]; infinite without load.
/// Source: [ISO281, eq. 3].
[[nodiscard]] double basic_rating_life(double load_rating, double equivalent_load);

}  // namespace raceway::life
