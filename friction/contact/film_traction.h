#pragma once

#include "friction/contact/traction.h"

namespace raceway::friction::contact {

/// True if a contact of half axis a has spin in addition to differential slip. The spin at the
/// controlling race is zero but for rounding: below 1e-9 of the differential slip ω_roll/(2 R) a it
/// counts as zero.
[[nodiscard]] inline bool spins_beside(double spin, double differential, double semi_major_axis) {
  return std::abs(spin) > 1e-9 * std::abs(differential) * semi_major_axis;
}

/// rolling_traction() of a film, fast: the same laws and equations with the points side by side,
/// v_x0 sought in single precision and confirmed in double.
///
/// 12 x 16 points of the half ellipse, 16 x 12 of the quarter where nothing spins. v_x0 is found to
/// 1e-6 of its range, as power hardly depends on it: where τ goes with v^m its slope over v_x0 is
/// (1 + m) Σ τ_x = 0, for dry friction as for a viscous film.
/// Accuracy: power 0.2 % with dry friction alone, 0.05 % with a film; against rolling_traction()
/// with the same points 1e-6 (tested). No memory is allocated.
[[nodiscard]] Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear);

/// Does this from a start: -v_x0 is sought from `centre` of its range on [1], and is left there for
/// a contact like this one, as of the next ball on the ring: nearby it takes one pass over the
/// points, not three or four.
[[nodiscard]] Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear,
                                     double& centre);
/// Start of that search without a contact like it.
inline constexpr double usual_centre = 0.2;

}  // namespace raceway::friction::contact
