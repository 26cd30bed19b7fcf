#pragma once

#include <cmath>
#include <cstddef>

#include "bearing/bearing.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/hertz.h"
#include "record/units.h"

namespace raceway::friction {

/// Friction moment that resists the spin of one Hertz contact about its normal, per unit of the
/// friction coefficient [N m]:
///
///   M_s / μ = (3/8) Q a E(k)
///
/// Q is the contact load. a and b are the semi-major and the semi-minor axis of the contact
/// ellipse. E(k) is the complete elliptic integral of the second kind with the modulus
/// k = sqrt(1 - (b/a)²). For a circular contact M_s / μ = (3 π/16) Q a.
///
/// Source:   [Harris2006, vol. 2, ch. 5; CaseStudy, eq. 23].
/// Domain:   every load; the moment is 0 for Q <= 0.
/// Accuracy: the code agrees with the formula to rounding error. Physical assumptions: one friction
///           coefficient over the whole ellipse, and no sliding except spin. Additional sliding in
///           another direction lowers the true spin moment.
[[nodiscard]] inline double unit_spin_moment(const bearing::HertzContact& contact, double load) {
  if (load <= 0.0) return 0.0;
  return 0.375 * load * contact.semi_major_axis(load) * contact.second_integral;
}

/// Quantity with one value for the inner and one value for the outer contacts.
struct ContactPair {
  double inner = 0.0;
  double outer = 0.0;
};

/// Friction moment of the whole bearing from the spin of all balls, per unit of the friction
/// coefficient, for inner and outer contacts [N m]:
///
///   M / μ = Σ (3/8) Q a E(k) ω_s/ω      over the balls, at the inner and at the outer contact
///
/// ω_s is the spin speed of a contact and ω the shaft speed; unit_spin_moment() describes Q, a and
/// E(k). The power M ω equals the sum of M_s ω_s over all contacts (M_s: spin moment of a contact).
/// The loads and contact angles of the balls can differ. Under outer control only the inner
/// contacts spin; under inner control only the outer contacts spin.
///
/// Source:   derived from unit_spin_moment() by a power balance; ω_s by [Jones1960] as in
///           bearing/kinematics.h.
/// Domain:   the moment is NaN without a converged equilibrium. At standstill, the moment is the
///           limit as the speed approaches zero, because ω_s/ω depends only on the contact angles.
[[nodiscard]] inline ContactPair unit_spin_friction(const bearing::Bearing& bearing,
                                                    const bearing::BearingEquilibrium& equilibrium,
                                                    bearing::RaceControl race_control) {
  if (!equilibrium.report.converged()) return {unset, unset};
  const bearing::HertzContact& inner = bearing.contact(bearing::Race::inner);
  const bearing::HertzContact& outer = bearing.contact(bearing::Race::outer);
  // M_s = M_s(1 N) Q^(4/3), because a is proportional to the cube root of the load.
  const double inner_unit = unit_spin_moment(inner, 1.0), outer_unit = unit_spin_moment(outer, 1.0);
  const auto moment = [](double unit, double load) { return unit * load * std::cbrt(load); };
  const bearing::Balls& balls = equilibrium.balls;
  ContactPair sum;
  for (std::size_t i = 0; i < balls.distinct().size(); ++i) {
    const bearing::BallEquilibrium& ball = balls.distinct()[i];
    // Without inner contact, outer control applies: the outer contact of the ball does not spin.
    if (!(ball.inner_load > 0.0)) continue;
    const bearing::BallRotation r =
        bearing::ball_rotation(race_control, ball.inner_contact_angle, ball.outer_contact_angle,
                               bearing.geometry().diameter_ratio(), 1.0);
    if (race_control == bearing::RaceControl::outer)
      sum.inner += balls.weight(i) * moment(inner_unit, ball.inner_load) * r.inner_spin_speed;
    else
      sum.outer += balls.weight(i) * moment(outer_unit, ball.outer_load) * r.outer_spin_speed;
  }
  return sum;
}

}  // namespace raceway::friction
