#pragma once

#include "friction/contact/traction.h"

namespace raceway::friction::contact {

/// True if a contact of half axis a has spin in addition to differential slip. The spin at the
/// controlling race is zero except for rounding: below 1e-9 of the differential slip ω_roll/(2 R) a
/// it counts as zero.
[[nodiscard]] inline bool spins_beside(double spin, double differential, double semi_major_axis) {
  return std::abs(spin) > 1e-9 * std::abs(differential) * semi_major_axis;
}

/// Fast version of rolling_traction() for a film: the same laws and equations, vectorized over the
/// points. v_x0 is found in single precision and confirmed in double.
///
/// 12 x 16 points of the half ellipse, 16 x 12 of the quarter where nothing spins. v_x0 is found to
/// 1e-6 of its range, as power hardly depends on it: where τ goes with v^m its slope over v_x0 is
/// (1 + m) Σ τ_x = 0, for dry friction as for a viscous film.
/// Accuracy: power 0.2 % with dry friction alone, 0.05 % with a film; against rolling_traction()
/// with the same points 1e-6 (tested). No memory is allocated.
[[nodiscard]] Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear);

/// As above, starting the search for -v_x0 at `centre`, a share of its range [1]. On return
/// `centre` is the solution, a start for a similar contact such as the next ball. A close start
/// needs one pass over the points instead of three or four.
[[nodiscard]] Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear,
                                     double& centre);
/// Start of that search without a similar contact.
inline constexpr double usual_centre = 0.2;

}  // namespace raceway::friction::contact
