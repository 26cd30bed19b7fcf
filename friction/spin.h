#pragma once

#include <cstddef>

#include "bearing/bearing.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/hertz.h"
#include "bearing/units.h"

namespace raceway::friction {

/// Friction moment that resists the spin of one Hertz contact about its normal, per unit of the
/// friction coefficient [N m]:
///
///   M_s / μ = (3/8) Q a E(k)
///
/// a is the semi-major axis of the contact ellipse, E(k) the complete elliptic integral of the
/// second kind of modulus k = sqrt(1 - (b/a)²); for a circle it is (3 π/16) Q a.
///
/// Source:   [Harris2006, vol. 2, ch. 5; CaseStudy, eq. 23].
/// Domain:   every load; 0 where Q <= 0.
/// Accuracy: the formula to rounding. Physically: one friction coefficient over the whole ellipse,
///           and spin alone slides; sliding in another direction as well lowers the true moment.
[[nodiscard]] inline double unit_spin_moment(const bearing::HertzContact& contact, double load) {
  if (load <= 0.0) return 0.0;
  return 0.375 * load * contact.semi_major_axis(load) * contact.second_integral;
}

/// One value for the inner and one for the outer contacts.
struct ContactPair {
  double inner = 0.0;
  double outer = 0.0;
};

/// Friction moment of the whole bearing that makes good the spin of all its balls, per unit of the
/// friction coefficient, by contact [N m]:
///
///   M / μ = Σ (3/8) Q a E(k) ω_s/ω      over the balls, at the inner and at the outer contact
///
/// times the shaft speed it is the power of all contacts at their spin speeds: only the spin moment
/// is per contact, and only here a sum over balls belongs. Under outer control just the inner
/// contacts spin, under inner control just the outer ones.
///
/// Source:   power balance of the law above; ω_s by [Jones1960] as in bearing/kinematics.h.
/// Domain:   converged equilibrium, else NaN. ω_s/ω follows from the contact angles alone, so the
///           moment has a value at standstill: the limit of slow rotation.
[[nodiscard]] inline ContactPair unit_spin_friction(const bearing::Bearing& bearing,
                                                    const bearing::BearingEquilibrium& equilibrium,
                                                    bearing::RaceControl race_control) {
  if (!equilibrium.report.converged()) return {unset, unset};
  ContactPair sum;
  ContactPair one;
  const bearing::BallEquilibrium* last = nullptr;
  for (std::size_t k = 0; k < equilibrium.balls.size(); ++k) {
    const bearing::BallEquilibrium& ball = equilibrium.balls[k];
    // A ball off the inner race is under outer control: neither contact spins.
    if (!(ball.inner_load > 0.0)) continue;
    // Under pure thrust all balls are alike; their trigonometry is done once.
    const bool same = last != nullptr && ball.inner_load == last->inner_load &&
                      ball.outer_load == last->outer_load &&
                      ball.inner_contact_angle == last->inner_contact_angle &&
                      ball.outer_contact_angle == last->outer_contact_angle;
    if (!same) {
      const bearing::BallSpeeds speeds = equilibrium.speeds(k, bearing, 1.0, race_control);
      const bearing::HertzContact& inner = bearing.contact(bearing::Race::inner);
      const bearing::HertzContact& outer = bearing.contact(bearing::Race::outer);
      one.inner = unit_spin_moment(inner, ball.inner_load) * speeds.inner_spin_speed;
      one.outer = unit_spin_moment(outer, ball.outer_load) * speeds.outer_spin_speed;
      last = &ball;
    }
    sum.inner += one.inner;
    sum.outer += one.outer;
  }
  return sum;
}

}  // namespace raceway::friction
