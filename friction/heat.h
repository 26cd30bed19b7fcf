#pragma once

#include <cmath>
#include <cstddef>

#include "friction/spin.h"
#include "friction/state.h"

namespace raceway::friction {

/// Friction power P = M ω, which becomes heat [W].
///
/// M is the friction moment of the whole bearing, so the number of balls Z is not a factor.
/// Source: [CaseStudy, eq. 19], where the factor Z is a misprint.
template <typename T>
T power_loss(const T& friction_moment, const T& speed) {
  return friction_moment * speed;
}

/// Friction moments of one bearing, grouped by the place where their heat arises [N m].
struct HeatSources {
  double load = 0.0;  ///< load moment of the base law
  /// Viscous moment of the base law plus the moments of effects whose heat has no known place.
  double viscous = 0.0;
  /// Friction coefficient of the effect `spin-friction` [1]; 0 without this effect.
  double spin_coefficient = 0.0;
};

/// Heat of each ring [W]. The sum over both rings equals the power loss to within rounding error.
struct HeatSplit {
  double inner = unset;
  double outer = unset;
};

/// Splits the friction power of a bearing between its rings.
///
///   spin      μ Σ (3/8) Q a E(k) ω_s   at the spinning contact
///   load      in proportion to         Σ Q v
///   viscous   in proportion to         Σ v
///   v_i = (ω - ω_m) (d_m - D cos αi)/2,   v_o = ω_m (d_m + D cos αo)/2
///
/// Each sum is over the balls that touch the race. v is the rolling speed at a contact, v_i at the
/// inner race and v_o at the outer race. All heat of an inner contact is assigned to the inner
/// ring, including the heat that flows into the ball. The split of spin friction is exact. The
/// splits of load and viscous friction are assumptions: the load friction of a contact is
/// proportional to Q v, and the viscous friction of a contact to v. The assumption for viscous
/// friction implies equal film thickness at both races. At low speed, Q and v are equal at both
/// contacts, so each ring gets half of the heat from load friction and from viscous friction. If no
/// ball is loaded, each ring also gets half of the heat from load and viscous friction. μ is
/// HeatSources::spin_coefficient, and spin.h describes a, E(k) and ω_s. Q is the contact load, ω
/// the shaft speed and ω_m the orbital speed of the balls. αi and αo are the contact angles, D is
/// the ball diameter and d_m the pitch diameter.
///
/// Domain:   the heat is NaN without a converged equilibrium, and zero at standstill.
[[nodiscard]] inline HeatSplit split_heat(const BearingState<double>& s,
                                          const HeatSources& sources) {
  if (s.equilibrium == nullptr || !s.equilibrium->report.converged()) return {};
  const bearing::BearingGeometry& g = s.bearing->geometry();
  ContactPair by_load, by_path;
  const bearing::Balls& balls = s.equilibrium->balls;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    const double weight = balls.weight(k);
    if (!(ball.outer_load > 0.0)) continue;
    const double cage = s.equilibrium->speeds(k, *s.bearing, 1.0, s.race_control).cage_speed;
    const double outer_speed =
        cage * (g.pitch_diameter + g.ball_diameter * std::cos(ball.outer_contact_angle));
    by_load.outer += weight * ball.outer_load * outer_speed;
    by_path.outer += weight * outer_speed;
    if (!(ball.inner_load > 0.0)) continue;
    const double inner_speed =
        (1.0 - cage) * (g.pitch_diameter - g.ball_diameter * std::cos(ball.inner_contact_angle));
    by_load.inner += weight * ball.inner_load * inner_speed;
    by_path.inner += weight * inner_speed;
  }
  // Without a loaded ball, the sums over the balls are zero. Each ring then gets half of the load
  // and viscous friction.
  const auto inner_share = [](const ContactPair& w) {
    const double sum = w.inner + w.outer;
    return sum > 0.0 ? w.inner / sum : 0.5;
  };
  const ContactPair spin = unit_spin_friction(*s.bearing, *s.equilibrium, s.race_control);
  const double load_inner = inner_share(by_load) * sources.load;
  const double viscous_inner = inner_share(by_path) * sources.viscous;
  return {.inner = power_loss(load_inner + viscous_inner + sources.spin_coefficient * spin.inner,
                              s.speed),
          .outer = power_loss((sources.load - load_inner) + (sources.viscous - viscous_inner) +
                                  sources.spin_coefficient * spin.outer,
                              s.speed)};
}

}  // namespace raceway::friction
