#pragma once

#include "bearing/geometry.h"

/// Bearing life: ratings and lives of ISO 281 and ISO/TS 16281.
namespace raceway::life {

/// Factor f_c of the dynamic rating of single-row radial and angular contact ball bearings [1], as
/// a function of γ = D cos α/d_m. The factor is linear in γ between table values, which have steps
/// of 0.01 in γ.
///
/// Source:   [ISO281, table 2], from two transcripts that agree, not checked against the print.
/// Domain:   γ from 0.01 to 0.40; NaN outside.
/// Trap:     the factor is valid for the conformities f_i <= 0.52 and f_o <= 0.53. Smaller
///           conformities do not raise the rating. Larger conformities lower the true rating; for
///           these, the standard refers to ISO/TR 1281-1.
[[nodiscard]] double rating_factor(double gamma);

/// Dynamic radial load rating of one row of balls [N]: 90 % of bearings survive a million
/// revolutions at this load.
///
///   C = 1.3 f_c cos^0.7 α Z^(2/3) D^1.8              D <= 25.4 mm
///   C = 1.3 f_c cos^0.7 α Z^(2/3) 3.647 D^1.4        D >  25.4 mm
///
/// The published formula has D in mm and C in N; the function converts D. α is the nominal contact
/// angle.
/// Source:   [ISO281, eqs. 1, 2, and table 1 for the factor 1.3], from transcripts, not checked
///           against the print.
/// Domain:   α from 0 to 45 deg (a radial bearing), and γ in the range of rating_factor(); NaN
///           outside.
/// Accuracy: the code agrees with the formula to rounding error. Catalogues of bearings of good
///           steel have up to 15 % higher ratings.
[[nodiscard]] double dynamic_load_rating(const bearing::BearingGeometry& geometry);

/// Largest contact angle of a radial bearing [rad].
inline constexpr double steepest_radial_angle = 45.0 * degree;

}  // namespace raceway::life
