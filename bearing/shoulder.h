#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Angle of a shoulder's edge from the bottom of the groove, measured at the groove's centre like a
/// contact angle [rad]. The angle is NaN if no shoulder diameter is given.
///
///   inner   cos θ = (R_i - d_s/2)/r_i,   r_i = f_i D,   R_i = d_m/2 + (f_i - 0.5) D cos α0
///   outer   cos θ = (d_s/2 - R_o)/r_o,   r_o = f_o D,   R_o = d_m/2 - (f_o - 0.5) D cos α0
///
/// Source:   geometry, derived. Both formulas equal cos θ = 1 - h/r with the land height h of
///           [Harris2006]: d_s/2 - (R_i - r_i) at the inner, R_o + r_o - d_s/2 at the outer ring.
/// Domain:   shoulder diameters d_s that validated(BearingGeometry) accepts.
[[nodiscard]] double shoulder_angle(const BearingGeometry& geometry, Race race);

/// Angular margin between the contact ellipse and the shoulder's edge [rad]:
///
///   θ - (α + asin(a/r))
///
/// θ is shoulder_angle(), α is the contact angle, a is the half axis of the ellipse across the
/// rolling direction, and r is the groove radius. The result is the smallest margin of all balls
/// that touch. If the margin is below zero, the edge of the shoulder truncates the ellipse, and the
/// pressure at the edge is higher than Hertz theory predicts.
/// Source:   comparison of the static ellipse with the land height, as in [Harris2006, vol. 1];
///           from memory, not checked against the print.
/// Domain:   a bearing in equilibrium. For α0 = 0 (deep groove, two shoulders) |α| replaces α;
///           otherwise the groove has a shoulder on one side only. The margin is NaN without a
///           shoulder diameter, or if no ball touches.
/// Accuracy: the model assumes a sharp edge. A real edge is rounded over about 0.1 mm, or 1 deg.
struct ShoulderMargins {
  double inner = unset, outer = unset;
  /// Truncated share of the ellipse's length, at the ball with the smallest margin [1].
  double inner_cut = 0.0, outer_cut = 0.0;
};
[[nodiscard]] ShoulderMargins shoulder_margins(const Bearing& bearing,
                                               const BearingEquilibrium& equilibrium);

/// Pure axial load at standstill under which the ellipse of a race reaches the edge of its shoulder
/// [N]. The search treats a load without equilibrium as too large.
///
/// Domain:   the load is NaN without a shoulder diameter, 0 if the angle of the edge is at
///           most the nominal contact angle, and infinite if no load up to 1e8 N reaches the edge.
/// Accuracy: the relative numerical error is 1e-9. This load is a limit of the geometry only; the
///           contact pressure may exceed 4.2 GPa.
struct PermissibleLoads {
  double inner = unset, outer = unset;
  /// Returns the smaller of both loads; a NaN load is ignored.
  [[nodiscard]] double least() const { return std::fmin(inner, outer); }
};
[[nodiscard]] PermissibleLoads permissible_axial_loads(const Bearing& bearing);

}  // namespace raceway::bearing
