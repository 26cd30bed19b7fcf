#pragma once

#include "friction/contact/traction.h"

namespace raceway::friction::contact {

/// True if a contact of half axis a has spin in addition to differential slip. The spin at the
/// controlling race is zero except for rounding. Spin below 1e-9 of the differential slip ω_roll/(2
/// R) a is treated as zero.
[[nodiscard]] inline bool spins_beside(double spin, double differential, double semi_major_axis) {
  return std::abs(spin) > 1e-9 * std::abs(differential) * semi_major_axis;
}

/// Fast version of rolling_traction() for a film: the same laws and equations, vectorized over the
/// points. v_x0 is found in single precision and confirmed in double.
///
/// With spin, the function uses 12 x 16 points of half the ellipse, without spin 16 x 12 points of
/// a quarter. An accuracy of v_x0 of 1e-6 of its range is enough, because the power hardly depends
/// on v_x0: if τ is proportional to v^m, the slope of the power over v_x0 is (1 + m) Σ τ_x = 0,
/// both for dry friction and for a viscous film.
/// Accuracy: power 0.2 % with dry friction only, 0.05 % with a film; 1e-6 compared with
///           rolling_traction() with the same points (tested). No memory is allocated.
[[nodiscard]] Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear);

/// Overload that starts the search for -v_x0 at `centre`, as a share of the range of v_x0 [1]. On
/// return `centre` is the solution. The solution is a good start for a similar contact, such as the
/// next ball. A close start needs one pass over the points instead of three or four.
[[nodiscard]] Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear,
                                     double& centre);
/// Start of this search if no similar contact is known.
inline constexpr double usual_centre = 0.2;

}  // namespace raceway::friction::contact
