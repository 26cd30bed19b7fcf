#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Angle θ of the edge of a shoulder [rad]: measured from the bottom of the groove, at the groove
/// centre, like a contact angle. The angle is NaN if no shoulder diameter is given.
///
///   inner   cos θ = (R_i - d_s/2)/r_i,   r_i = f_i D,   R_i = d_m/2 + (f_i - 0.5) D cos α0
///   outer   cos θ = (d_s/2 - R_o)/r_o,   r_o = f_o D,   R_o = d_m/2 - (f_o - 0.5) D cos α0
///
/// Source:   geometry, derived. d_s is the shoulder diameter; the other symbols are explained in
///           BearingGeometry. Both formulas equal cos θ = 1 - h/r with the shoulder height h of
///           [Harris2006].
/// Domain:   shoulder diameters d_s that validated(BearingGeometry) accepts.
[[nodiscard]] double shoulder_angle(const BearingGeometry& geometry, Race race);

/// Angular margin between the contact ellipse and the edge of the shoulder [rad]:
///
///   θ - (α + asin(a/r))
///
/// θ is shoulder_angle(), α is the contact angle, a is the half axis of the ellipse across the
/// rolling direction, and r is the groove radius. The result is the smallest margin of all balls
/// that touch the race. If the margin is below zero, the edge of the shoulder truncates the
/// ellipse, and the pressure at the edge is higher than Hertz theory predicts.
/// Source:   comparison of the contact ellipse with the shoulder height, as in [Harris2006, vol.
///           1]; not checked against the book.
/// Domain:   a bearing in equilibrium. For a deep-groove bearing (α0 = 0, two shoulders), |α|
///           replaces α. Other bearings have a shoulder on one side only. The margin is NaN if no
///           shoulder diameter is given, or if no ball touches the race.
/// Accuracy: the model assumes a sharp edge. A real edge is rounded over about 0.1 mm, which is
///           about 1 deg of θ.
struct ShoulderMargins {
  double inner = unset, outer = unset;
  /// Truncated length of the ellipse divided by its whole length, at the ball with the smallest
  /// margin [1].
  double inner_cut = 0.0, outer_cut = 0.0;
};
[[nodiscard]] ShoulderMargins shoulder_margins(const Bearing& bearing,
                                               const BearingEquilibrium& equilibrium);

/// Pure axial load at standstill under which the contact ellipse of a race reaches the edge of the
/// shoulder [N]. An axial load under which the solver finds no equilibrium is treated as above the
/// permissible load.
///
/// Domain:   the result is NaN without a shoulder diameter. The result is 0 if shoulder_angle() is
///           not above the nominal contact angle. The result is infinite if the ellipse does not
///           reach the edge under loads up to 1e8 N.
/// Accuracy: the relative numerical error is 1e-9. The load is a limit for the ellipse, not for the
///           contact pressure, which may exceed the static limit of 4.2 GPa at this load.
struct PermissibleLoads {
  double inner = unset, outer = unset;
  /// Returns the smaller of `inner` and `outer`. A value that is NaN is ignored.
  [[nodiscard]] double least() const { return std::fmin(inner, outer); }
};
[[nodiscard]] PermissibleLoads permissible_axial_loads(const Bearing& bearing);

}  // namespace raceway::bearing
