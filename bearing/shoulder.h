#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Angle of a shoulder's edge from the bottom of the groove, measured at the groove's centre like a
/// contact angle [rad]. NaN where no shoulder diameter is given.
///
///   inner   cos θ = (R_i - d_s/2)/r_i,   r_i = f_i D,   R_i = d_m/2 + (f_i - 0.5) D cos α0
///   outer   cos θ = (d_s/2 - R_o)/r_o,   r_o = f_o D,   R_o = d_m/2 - (f_o - 0.5) D cos α0
///
/// Source:   geometry, derived. Equal to cos θ = 1 - h/r with the land heights
///           h = d_s/2 - (R_i - r_i) of [Harris2006].
/// Domain:   d_s of validated(BearingGeometry).
[[nodiscard]] double shoulder_angle(const BearingGeometry& geometry, Race race);

/// Angular margin between the contact ellipse and the shoulder's edge [rad]:
///
///   θ - (α + asin(a/r))
///
/// a: half axis of the ellipse across rolling; the least of all balls that touch. Below zero the
/// shoulder cuts the ellipse off, and its edge carries more than Hertz says.
/// Source:   static ellipse against land height as in [Harris2006, vol. 1], from memory, print not
///           seen.
/// Domain:   an equilibrium. α is |α| for α0 = 0 (deep groove, two shoulders); otherwise there is
///           no shoulder beyond the bottom of the groove. NaN without a shoulder, or if no ball
///           touches.
/// Accuracy: the shoulder has a sharp edge here; a real one is rounded over a tenth of a millimetre
///           or so, some 1 deg.
struct ShoulderMargins {
  double inner = unset, outer = unset;
  /// Share of the ellipse's length that is cut off, at the ball with the least margin [1].
  double inner_cut = 0.0, outer_cut = 0.0;
};
[[nodiscard]] ShoulderMargins shoulder_margins(const Bearing& bearing,
                                               const BearingEquilibrium& equilibrium);

/// Pure axial load at standstill under which the ellipse of a race reaches the edge of its shoulder
/// [N], by the equilibrium of the bearing at each load.
///
/// Domain:   NaN without a shoulder; 0 where the edge lies below the nominal contact already;
///           infinite where nothing up to 1e8 N reaches it.
/// Accuracy: 1e-9 relative. A limit of the geometry: the pressure there may be above 4.2 GPa.
struct PermissibleLoads {
  double inner = unset, outer = unset;
  /// Returns the smaller of the known values.
  [[nodiscard]] double least() const { return std::fmin(inner, outer); }
};
[[nodiscard]] PermissibleLoads permissible_axial_loads(const Bearing& bearing);

}  // namespace raceway::bearing
