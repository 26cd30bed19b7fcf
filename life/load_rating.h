#pragma once

#include "bearing/geometry.h"

/// Bearing life: ratings and lives of ISO 281 and ISO/TS 16281.
namespace raceway::life {

/// Factor f_c of the dynamic rating of single-row radial and angular contact ball bearings [1], as
/// a function of γ = D cos α/d_m (D: ball diameter, α: contact angle, d_m: pitch diameter). The
/// factor is interpolated linearly in a table with steps of 0.01 in γ.
///
/// Source:   [ISO281, table 2], from two transcripts that agree, not checked against the printed
///           standard.
/// Domain:   γ from 0.01 to 0.40. Outside this range, the factor is NaN.
/// Trap:     the factor is valid for conformities up to 0.52 (inner ring) and 0.53 (outer ring).
///           Smaller conformities do not increase the rating. Larger conformities reduce the true
///           rating; for such bearings, the standard refers to ISO/TR 1281-1.
[[nodiscard]] double rating_factor(double gamma);

/// Dynamic radial load rating C of one row of balls [N]. At this load, 90 % of bearings survive a
/// million revolutions.
///
///   C = 1.3 f_c cos^0.7 α Z^(2/3) D^1.8              D <= 25.4 mm
///   C = 1.3 f_c cos^0.7 α Z^(2/3) 3.647 D^1.4        D >  25.4 mm
///
/// In the published formula, the ball diameter D is in mm; the function converts D from m. Z is the
/// number of balls, and α is the nominal contact angle. f_c comes from rating_factor().
/// Source:   [ISO281, eqs. 1, 2, and table 1 for the factor 1.3], from transcripts, not checked
///           against the printed standard.
/// Domain:   radial bearings (α from 0 to 45 deg), with γ in the range of rating_factor(). Outside
///           this range, the rating is NaN.
/// Accuracy: the code agrees with the formula to rounding error. For bearings of high-quality
///           steel, catalogues give ratings that are up to 15 % higher.
[[nodiscard]] double dynamic_load_rating(const bearing::BearingGeometry& geometry);

/// Largest contact angle of a radial bearing [rad].
inline constexpr double steepest_radial_angle = 45.0 * degree;

}  // namespace raceway::life
