#pragma once

#include <cmath>

#include "bearing/bearing.h"
#include "bearing/kinematics.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Shape of all contacts of one race, at the nominal contact angle, as in Bearing::contact().
///
///   R_x = D (1 ∓ γ)/2,  γ = D cos α0/d_m,  upper sign at the inner race;   R_z = f D/(2 f - 1)
///   R = 2 f D/(2 f + 1)
///
/// D is the ball diameter, d_m the pitch diameter, α0 the nominal contact angle and f the
/// conformity.
struct ContactShape {
  double radius_along = unset;    ///< R_x, equivalent radius along rolling [m]
  double radius_across = unset;   ///< R_z, equivalent radius across rolling [m]
  double pressed_radius = unset;  ///< R, radius of the deformed contact across rolling [m]
  /// E' = 2/((1-ν1²)/E1 + (1-ν2²)/E2), with the elastic moduli E and the Poisson ratios ν of ball
  /// and ring [Pa].
  double modulus = unset;
  double ellipse_ratio = unset;    ///< k = a/b, ratio of the semi-axes of the ellipse [1]
  double second_integral = unset;  ///< E(k), complete elliptic integral of the second kind [1]
  double unit_major_axis = unset;  ///< a at 1 N load [m]; a grows with the cube root of the load
};

[[nodiscard]] inline ContactShape contact_shape(const bearing::Bearing& bearing,
                                                bearing::Race race) {
  const bearing::BearingGeometry& g = bearing.geometry();
  const bearing::HertzContact& hertz = bearing.contact(race);
  const bool inner = race == bearing::Race::inner;
  const double f = inner ? g.inner_conformity : g.outer_conformity;
  const double gamma = g.diameter_ratio() * std::cos(g.contact_angle);
  const double D = g.ball_diameter;
  return {.radius_along = 0.5 * D * (inner ? 1.0 - gamma : 1.0 + gamma),
          .radius_across = f * D / (2.0 * f - 1.0),
          .pressed_radius = 2.0 * f * D / (2.0 * f + 1.0),
          .modulus = 2.0 * hertz.contact_modulus,
          .ellipse_ratio = hertz.ellipse_ratio,
          .second_integral = hertz.second_integral,
          .unit_major_axis = hertz.semi_major_axis(1.0)};
}

/// Relative motion of ball and race at one contact.
struct ContactMotion {
  double surface_speed = 0.0;  ///< u, mean speed of both surfaces relative to the cage [m/s]
  double rolling = 0.0;  ///< ω_roll, relative rotation about the tangent across rolling [rad/s]
  double spin = 0.0;     ///< ω_s, relative rotation about the normal, magnitude [rad/s]
};

/// Motion at both contacts of a ball that rolls without slip at the contact centres.
///
///   u_i = (ω - ω_m)(d_m - D cos αi)/2,   u_o = ω_m (d_m + D cos αo)/2
///   ω_roll,i = ω_R cos(αi - β) + (ω - ω_m) cos αi,   ω_roll,o = ω_R cos(αo - β) - ω_m cos αo
///
/// ω is the shaft speed, ω_m the orbital speed of the ball, and ω_R the rotation of the ball
/// relative to the cage. β is the angle between the rotation axis of the ball and the bearing axis.
/// αi and αo are the contact angles, d_m is the pitch diameter and D the ball diameter. For the
/// spin speeds, see bearing/kinematics.h. The formulas are valid for inner and outer race control.
struct BallMotion {
  ContactMotion inner, outer;
};

[[nodiscard]] inline BallMotion ball_motion(const bearing::BearingGeometry& g,
                                            const bearing::BallRotation& r,
                                            double inner_contact_angle, double outer_contact_angle,
                                            double speed) {
  const double D = g.ball_diameter, d_m = g.pitch_diameter;
  const double si = std::sin(inner_contact_angle), ci = std::cos(inner_contact_angle);
  const double so = std::sin(outer_contact_angle), co = std::cos(outer_contact_angle);
  return {.inner = {.surface_speed = 0.5 * (speed - r.cage_speed) * (d_m - D * ci),
                    .rolling = r.along * ci + r.across * si + (speed - r.cage_speed) * ci,
                    .spin = r.inner_spin_speed},
          .outer = {.surface_speed = 0.5 * r.cage_speed * (d_m + D * co),
                    .rolling = r.along * co + r.across * so - r.cage_speed * co,
                    .spin = r.outer_spin_speed}};
}

}  // namespace raceway::friction::contact
