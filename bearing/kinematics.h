#pragma once

#include <cmath>

namespace raceway::bearing {

/// Race that controls the ball. The ball rolls without spin at this race.
enum class RaceControl { outer, inner };

/// Returns the ratio m = ω_m/ω of the orbital speed of a ball (cage speed) to the speed ω of the
/// inner ring [1]. The outer ring is stationary. αi and αo are the contact angles at the inner and
/// the outer race, D is the ball diameter and d_m the pitch diameter.
///
///   outer control   m = (1 - g cos αi) / (1 + cos(αi - αo))
///   inner control   m = (cos(αi - αo) - g cos αo) / (1 + cos(αi - αo)),        g = D/d_m
///
/// Source: [Harris2006, vol. 2, ch. 5; Jones1960]. For αi = αo = α, both formulas give (1 - g cos
///         α)/2.
template <typename T>
T cage_speed_ratio(RaceControl control, const T& cos_inner, const T& cos_outer,
                   const T& cos_difference, const T& g) {
  if (control == RaceControl::outer) return (1.0 - g * cos_inner) / (1.0 + cos_difference);
  return (cos_difference - g * cos_outer) / (1.0 + cos_difference);
}

/// Rotation of a ball from an equilibrium of the friction forces, used instead of race control.
/// This rotation determines the orbital speed ratio m = ω_m/ω and the friction forces Ti and To in
/// the plane through the bearing axis and the ball centre.
///
///   m = p/(p + q) + m_c,   p = (1 - g cos αi) cos(αo - β),   q = (1 + g cos αo) cos(αi - β)
///   Ti, To = s times the given friction forces,   s = x (2 - x),   x = min(Qi/inner_load, 1)
///
/// p/(p + q) is the ratio m of a ball that rolls without slip at both contacts. The axis of the
/// ball has the pitch angle β to the bearing axis. β, the creep m_c and the given friction forces
/// stay constant while the contact angles change. The friction forces become zero when the inner
/// contact is lost. The default values are valid for a ball that touches only the outer race, under
/// outer control (αo = 0).
struct GivenRotation {
  double cos_pitch = 1.0, sin_pitch = 0.0;  ///< cosine and sine of β
  double creep = 0.0;                       ///< m_c, added to the ratio m [1]
  /// Friction forces Ti and To at the inner contact load `inner_load` [N]. BallBalanceOf explains
  /// their sign.
  double inner_friction = 0.0, outer_friction = 0.0;
  /// Inner contact load Qi for which the friction forces are given [N], > 0.
  double inner_load = 1.0;
  [[nodiscard]] bool operator==(const GivenRotation&) const = default;
};

/// Speeds of one ball [rad/s] and the pitch angle of its axis [rad].
struct BallSpeeds {
  double cage_speed;   ///< orbital speed ω_m about the bearing axis
  double ball_speed;   ///< ω_R about the ball's own axis, seen from the cage
  double pitch_angle;  ///< β between the ball's axis and the bearing axis
  /// Speed of the ball relative to the inner race about the contact normal; 0 under inner control.
  double inner_spin_speed;
  /// Speed of the ball relative to the outer race about the contact normal; 0 under outer control.
  double outer_spin_speed;
};

/// Speeds of a ball. The struct stores two components of the ball speed ω_R. speeds() computes ω_R
/// and its pitch angle β from these components. The formulas for outer and inner control are
///
///   outer   tan β = sin αo/(cos αo + g)
///           ω_R cos β = ω_m (cos αo + g)/g,         ω_R sin β = ω_m sin αo/g
///   inner   tan β = sin αi/(cos αi - g)
///           ω_R cos β = (ω - ω_m)(cos αi - g)/g,    ω_R sin β = (ω - ω_m) sin αi/g
///   both    ω_si = ω_R sin(αi - β) + (ω - ω_m) sin αi,   ω_so = -ω_R sin(αo - β) + ω_m sin αo
///
/// ω_si and ω_so are the spin speeds at inner and outer contact; the struct stores their
/// magnitudes. cage_speed_ratio() and BallSpeeds explain the other symbols.
/// Source: [Harris2006, vol. 2, ch. 5], for a ball that rolls without slip at both contacts. The
///         formulas for ω_R cos β and ω_R sin β follow from the formulas of Harris for ω_R and tan
///         β.
struct BallRotation {
  double cage_speed;     ///< ω_m [rad/s]
  double along, across;  ///< components of ω_R along and across the bearing axis [rad/s]
  double inner_spin_speed, outer_spin_speed;  ///< magnitudes [rad/s]

  [[nodiscard]] BallSpeeds speeds() const {
    return {.cage_speed = cage_speed,
            .ball_speed = std::hypot(along, across),
            .pitch_angle = std::atan2(across, along),
            .inner_spin_speed = inner_spin_speed,
            .outer_spin_speed = outer_spin_speed};
  }
};

[[nodiscard]] inline BallRotation ball_rotation(RaceControl control, double inner_contact_angle,
                                                double outer_contact_angle, double diameter_ratio,
                                                double speed) {
  const double g = diameter_ratio;
  const double si = std::sin(inner_contact_angle), ci = std::cos(inner_contact_angle);
  const double so = std::sin(outer_contact_angle), co = std::cos(outer_contact_angle);
  const double cage = speed * cage_speed_ratio(control, ci, co, ci * co + si * so, g);
  const bool outer = control == RaceControl::outer;
  const double along = outer ? cage * (co + g) / g : (speed - cage) * (ci - g) / g;
  const double across = outer ? cage * so / g : (speed - cage) * si / g;
  const double inner_spin = si * along - ci * across + (speed - cage) * si;
  const double outer_spin = -(so * along - co * across) + cage * so;
  return {cage, along, across, std::abs(inner_spin), std::abs(outer_spin)};
}

[[nodiscard]] inline BallSpeeds ball_speeds(RaceControl control, double inner_contact_angle,
                                            double outer_contact_angle, double diameter_ratio,
                                            double speed) {
  return ball_rotation(control, inner_contact_angle, outer_contact_angle, diameter_ratio, speed)
      .speeds();
}

/// Cage speed ratio p/(p + q) of a ball that rolls without slip at both contacts, about an axis
/// with the pitch angle β. See GivenRotation for p and q.
[[nodiscard]] inline double rolling_cage_ratio(double cos_pitch, double sin_pitch,
                                               double inner_contact_angle,
                                               double outer_contact_angle, double diameter_ratio) {
  const double si = std::sin(inner_contact_angle), ci = std::cos(inner_contact_angle);
  const double so = std::sin(outer_contact_angle), co = std::cos(outer_contact_angle);
  const double p = (1.0 - diameter_ratio * ci) * (co * cos_pitch + so * sin_pitch);
  const double q = (1.0 + diameter_ratio * co) * (ci * cos_pitch + si * sin_pitch);
  return p / (p + q);
}

/// Returns the speeds of a ball with the rotation `given`. The ball speed ω_R is the speed for
/// rolling without slip. The cage speed ω_m includes the creep m_c.
[[nodiscard]] inline BallRotation ball_rotation(const GivenRotation& given,
                                                double inner_contact_angle,
                                                double outer_contact_angle, double diameter_ratio,
                                                double speed) {
  const double g = diameter_ratio, cos_pitch = given.cos_pitch, sin_pitch = given.sin_pitch;
  const double si = std::sin(inner_contact_angle), ci = std::cos(inner_contact_angle);
  const double so = std::sin(outer_contact_angle), co = std::cos(outer_contact_angle);
  const double rolling =
      speed * rolling_cage_ratio(cos_pitch, sin_pitch, inner_contact_angle, outer_contact_angle, g);
  const double turning = rolling * (1.0 + g * co) / (g * (co * cos_pitch + so * sin_pitch));
  const double along = turning * cos_pitch, across = turning * sin_pitch;
  const double cage = rolling + speed * given.creep;
  const double inner_spin = si * along - ci * across + (speed - cage) * si;
  const double outer_spin = -(so * along - co * across) + cage * so;
  return {cage, along, across, std::abs(inner_spin), std::abs(outer_spin)};
}

}  // namespace raceway::bearing
