#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"
#include "friction/contact/contact_friction.h"
#include "friction/contact/slip_forces.h"

namespace raceway::friction::contact {

/// Rotation of a ball under traction at both contacts, without race control, and its results. At
/// standstill, speeds and powers are per rad/s of the shaft.
struct BallAttitude {
  double cage_speed = unset;       ///< ω_m [rad/s]
  double film_cage_speed = unset;  ///< ω_m used for the films [rad/s]
  /// Components of ω_R in the cage's frame: along the bearing axis and opposite to the shaft's
  /// rotation, radially outwards, and along the orbit [rad/s]. Under race control `orbital` is
  /// zero.
  double along = unset, across = unset, orbital = unset;
  SlipMotion inner_slip, outer_slip;
  Traction inner, outer;                            ///< traction at each contact
  double inner_force = unset, outer_force = unset;  ///< T_i, T_o as in BallBalance [N]
  double shaft_power = unset;                       ///< power taken from the shaft by traction [W]
  bearing::SolveReport report;

  [[nodiscard]] double ball_speed() const { return std::hypot(along, across, orbital); }
  /// β between the ball's axis, seen along the orbit, and the bearing axis [rad].
  [[nodiscard]] double pitch_angle() const { return std::atan2(across, along); }
};

class TurningBall;

/// Finds the rotation of the balls of one bearing at one speed and state of the oil.
///
/// A ball has four free speeds. The cage exerts no force. The conditions for traction at both
/// contacts are:
///
///   Σ τ_x equal at both contacts,   M = J ω_m x̂ × w
///   T_i + T_o = (2/D) J ω_m ω_R sin β   (component of M along the orbit)
///
/// M is the moment of traction about the centre of the ball, x̂ the direction of the bearing axis,
/// and w the rotation of the ball seen from the cage.
///
/// The unknowns are the slips at the centres of both contacts and ω_R sin β; the derivatives are
/// analytic. Traction follows from a potential that is convex in these speeds; the gyroscopic
/// moment adds a purely rotational term. So there is one solution for a given cage speed, and every
/// Newton step descends towards this solution. If dry friction changes direction too sharply, the
/// solver first smooths this change and then removes the smoothing.
///
/// Source:   derived from the slip field of traction.h. Race control is not assumed: in a full film
///           the ball turns until its gyroscopic moment vanishes (β near 0); under boundary
///           friction it approaches race control.
/// Domain:   speed >= 0; at standstill the result is the limit for slow rotation. The balls are
///           loaded. A ball without contact at the inner race rolls on the outer race without slip
///           at the centre of the contact.
/// Accuracy: forces to 1e-9 of the sum of |τ|; input power equals lost power to 1e-8. Film and
///           rolling resistance use the computed cage speed. Rolling resistance does not affect the
///           rotation of a ball.
class BallAttitudes {
 public:
  BallAttitudes(const bearing::Bearing& bearing, double speed, const OilState& oil,
                const ContactLaw& law);

  /// Solves the attitude of a ball under these loads at these contact angles. `start` is the
  /// attitude of a neighbouring ball, or of this ball at another load.
  [[nodiscard]] BallAttitude solve(const bearing::BallEquilibrium& ball,
                                   const BallAttitude* start = nullptr) const;
  /// Solves the attitude once, with films at the cage speed of `start`, or at the cage speed of
  /// outer control if there is no `start`. Use this function inside an iteration.
  [[nodiscard]] BallAttitude solve_once(const bearing::BallEquilibrium& ball,
                                        const BallAttitude* start = nullptr) const;

  /// Returns the friction of both contacts of a ball at this attitude.
  [[nodiscard]] ContactsOfBall contacts(const BallAttitude& attitude,
                                        const bearing::BallEquilibrium& ball) const;

  [[nodiscard]] const RaceFriction& race(bearing::Race race) const {
    return race == bearing::Race::inner ? inner_ : outer_;
  }
  /// Shaft speed used by solve(): 1 rad/s at standstill.
  [[nodiscard]] double turning() const { return speed_ > 0.0 ? speed_ : 1.0; }
  /// Factor of this speed for the films: 0 at standstill, else 1.
  [[nodiscard]] double film_speed() const { return speed_ > 0.0 ? 1.0 : 0.0; }

 private:
  [[nodiscard]] BallAttitude on_outer_race(const bearing::BallEquilibrium& ball) const;
  /// Computes the contacts of a ball on films formed at this cage speed. Returns true if asperities
  /// carry more than a tenth of the load of a contact.
  bool press(const bearing::BallEquilibrium& ball, double cage_speed, TurningBall& turned) const;

  const bearing::Bearing* bearing_;
  double speed_;
  RaceFriction inner_, outer_;
};

/// Returns the speeds of both contacts of a ball at this attitude.
[[nodiscard]] BallMotion ball_motion(const bearing::BearingGeometry& geometry,
                                     const BallAttitude& attitude,
                                     const bearing::BallEquilibrium& ball, double speed);

}  // namespace raceway::friction::contact
