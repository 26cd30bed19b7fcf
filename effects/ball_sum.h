#pragma once

#include <cmath>

#include "bearing/bearing.h"
#include "bearing/bearing_equilibrium.h"
#include "friction/state.h"

namespace raceway::effects {

/// One loaded contact of a ball and a race.
struct RollingContact {
  const bearing::HertzContact& hertz;
  double load;        ///< load Q of the contact [N]
  double conformity;  ///< f = groove radius / ball diameter [1]
  /// Ratio R_z/R_x of the equivalent radii across and along the rolling direction [1]; at least 1.
  double radius_ratio;
  double rolling_ratio;  ///< ratio of rolling speed to shaft speed, ω_roll/ω [1]
};

/// Returns the ratio of two equivalent radii of ball and groove: R_z across and R_x along the
/// rolling direction [1].
///
///   R_z/R_x = (1 + F(ρ))/(1 - F(ρ)),   R_x = D (1 ∓ γ)/2,   R_z = f D/(2 f - 1)
///
/// D is the ball diameter, f the conformity, and F(ρ) the curvature difference. γ is D cos α / d_m,
/// with the pitch diameter d_m and the nominal contact angle α, as in Bearing::contact(). In R_x,
/// the upper sign is for the inner race and the lower sign for the outer race.
/// Source: F(ρ) Σρ = 1/R_x - 1/R_z with the curvature sum Σρ = 1/R_x + 1/R_z, see
///         groove_curvature().
[[nodiscard]] inline double radius_ratio(const bearing::BearingGeometry& g, bearing::Race race) {
  const double F = bearing::groove_curvature(g, race, g.contact_angle).difference;
  return (1.0 + F) / (1.0 - F);
}

/// Returns the sum of `value` over all loaded contacts of balls and races. The result is NaN
/// without a converged equilibrium of the balls. The function `value` is called with the
/// RollingContact of each contact. RollingContact::rolling_ratio is the rolling speed ω_roll
/// divided by the shaft speed ω:
///
///   ω_roll,i = ω_R cos(αi - β) + (ω - ω_m) cos αi,   ω_roll,o = ω_R cos(αo - β) - ω_m cos αo
///
/// The indices i and o are for the inner and outer race. ω_m is the speed of the cage, and αi and
/// αo are the contact angles. In the frame of the cage, a ball rotates at the speed ω_R about an
/// axis at the angle β to the bearing axis (bearing/kinematics.h). If a moment M resists rolling at
/// a contact, the shaft supplies the power M ω_roll.
/// Source: derived. ω_roll is the rotation of the ball relative to the race about the contact
///         tangent across the rolling direction.
template <typename Value>
double sum_over_contacts(const friction::BearingState<double>& s, const Value& value) {
  if (s.equilibrium == nullptr || !s.equilibrium->report.converged()) return unset;
  const bearing::BearingGeometry& g = s.bearing->geometry();
  const bearing::Balls& balls = s.equilibrium->balls;
  const double inner_ratio = radius_ratio(g, bearing::Race::inner);
  const double outer_ratio = radius_ratio(g, bearing::Race::outer);
  double sum = 0.0;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    const bearing::BallSpeeds v = s.equilibrium->speeds(k, *s.bearing, 1.0, s.race_control);
    if (ball.inner_load > 0.0)
      sum +=
          balls.weight(k) *
          value(RollingContact{
              .hertz = s.bearing->contact(bearing::Race::inner),
              .load = ball.inner_load,
              .conformity = g.inner_conformity,
              .radius_ratio = inner_ratio,
              .rolling_ratio = v.ball_speed * std::cos(ball.inner_contact_angle - v.pitch_angle) +
                               (1.0 - v.cage_speed) * std::cos(ball.inner_contact_angle)});
    if (ball.outer_load > 0.0)
      sum +=
          balls.weight(k) *
          value(RollingContact{
              .hertz = s.bearing->contact(bearing::Race::outer),
              .load = ball.outer_load,
              .conformity = g.outer_conformity,
              .radius_ratio = outer_ratio,
              .rolling_ratio = v.ball_speed * std::cos(ball.outer_contact_angle - v.pitch_angle) -
                               v.cage_speed * std::cos(ball.outer_contact_angle)});
  }
  return sum;
}

}  // namespace raceway::effects
