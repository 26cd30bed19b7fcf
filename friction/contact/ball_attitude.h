#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"
#include "friction/contact/contact_friction.h"
#include "friction/contact/slip_forces.h"

namespace raceway::friction::contact {

/// Rotation of a ball, with the resulting slip, forces and power. Traction at both contacts
/// determines the rotation; race control is not assumed. At standstill, speeds and powers are
/// values for a shaft speed of 1 rad/s.
struct BallAttitude {
  double cage_speed = unset;       ///< ω_m, orbital speed of the ball [rad/s]
  double film_cage_speed = unset;  ///< cage speed used for the film thickness [rad/s]
  /// Components of ω_R, the rotation of the ball relative to the cage [rad/s]. `along` is parallel
  /// to the bearing axis and positive against the shaft rotation, `across` points radially
  /// outwards, and `orbital` points along the orbit. Under race control, `orbital` is zero.
  double along = unset, across = unset, orbital = unset;
  SlipMotion inner_slip, outer_slip;
  Traction inner, outer;                            ///< traction at each contact
  double inner_force = unset, outer_force = unset;  ///< T_i, T_o, transverse friction forces [N]
  double shaft_power = unset;  ///< power that traction takes from the shaft [W]
  bearing::SolveReport report;

  [[nodiscard]] double ball_speed() const { return std::hypot(along, across, orbital); }
  /// Pitch angle β between the bearing axis and the rotation axis of the ball, seen along the orbit
  /// [rad].
  [[nodiscard]] double pitch_angle() const { return std::atan2(across, along); }
};

class TurningBall;

/// Finds the rotation of the balls of one bearing at one shaft speed and one state of the oil.
///
/// A ball has four free speeds: the orbital speed and three components of rotation. The cage exerts
/// no force on the ball. The conditions for traction at both contacts are:
///
///   Σ τ_x equal at both contacts,   M = J ω_m x̂ × w
///   T_i + T_o = (2/D) J ω_m ω_R sin β   (component of M along the orbit)
///
/// Σ τ_x is the traction force of one contact along the rolling direction. T_i and T_o are the
/// transverse friction forces at the inner and outer contact. M is the moment of traction about the
/// centre of the ball, J the moment of inertia and D the diameter of the ball, x̂ the direction of
/// the bearing axis, and w the rotation of the ball relative to the cage. ω_R sin β is the radial
/// component of w.
///
/// The unknowns are the slips at the centres of both contacts and ω_R sin β. Traction is the
/// gradient of a potential that is convex in these unknowns. Therefore, exactly one ball rotation
/// exists for given film thicknesses.
///
/// Source:   derived from the slip field of traction.h. Race control is not assumed: in a full film
///           the rotation axis tilts until the gyroscopic moment vanishes (β near 0); under
///           boundary friction the rotation approaches race control.
/// Domain:   speed >= 0; at standstill, the result is the limit as the speed approaches zero. Each
///           ball must have a load at the outer race. A ball without contact at the inner race
///           rotates as under outer race control.
/// Accuracy: the forces on a ball balance to 1e-8 of Σ |τ| over both contacts, usually to 1e-10;
///           the relative difference of power input and power loss is at most 1e-8. Film thickness
///           and rolling resistance are computed at the resulting cage speed. The effect of rolling
///           resistance on the rotation of a ball is neglected.
class BallAttitudes {
 public:
  BallAttitudes(const bearing::Bearing& bearing, double speed, const OilState& oil,
                const ContactLaw& law);

  /// Returns the rotation of a ball for the loads and contact angles in `ball`. `start` is an
  /// initial guess, such as the rotation of a neighbouring ball.
  [[nodiscard]] BallAttitude solve(const bearing::BallEquilibrium& ball,
                                   const BallAttitude* start = nullptr) const;
  /// Returns the rotation of a ball, with the film thickness at the cage speed of `start`. Without
  /// a converged `start`, the film thickness is computed at the cage speed under outer race
  /// control. solve() repeats solve_once() until the cage speed of the result equals the cage speed
  /// used for the film thickness.
  [[nodiscard]] BallAttitude solve_once(const bearing::BallEquilibrium& ball,
                                        const BallAttitude* start = nullptr) const;

  /// Returns the friction at both contacts of a ball with the rotation `attitude`.
  [[nodiscard]] ContactsOfBall contacts(const BallAttitude& attitude,
                                        const bearing::BallEquilibrium& ball) const;

  [[nodiscard]] const RaceFriction& race(bearing::Race race) const {
    return race == bearing::Race::inner ? inner_ : outer_;
  }
  /// Shaft speed in the calculation [rad/s]: the speed of the bearing, or 1 rad/s at standstill.
  [[nodiscard]] double turning() const { return speed_ > 0.0 ? speed_ : 1.0; }
  /// Factor on the speed for the film thickness [1]: 0 at standstill, else 1.
  [[nodiscard]] double film_speed() const { return speed_ > 0.0 ? 1.0 : 0.0; }

 private:
  [[nodiscard]] BallAttitude on_outer_race(const bearing::BallEquilibrium& ball) const;
  /// Writes the ellipse and the shear law of both contacts of a ball to `turned`. The film
  /// thickness is computed at the given cage speed. Returns true if asperities carry more than a
  /// tenth of the load of at least one contact.
  bool press(const bearing::BallEquilibrium& ball, double cage_speed, TurningBall& turned) const;

  const bearing::Bearing* bearing_;
  double speed_;
  RaceFriction inner_, outer_;
};

/// Returns the surface, rolling and spin speeds at both contacts of a ball with the rotation
/// `attitude`. `speed` is the shaft speed [rad/s].
[[nodiscard]] BallMotion ball_motion(const bearing::BearingGeometry& geometry,
                                     const BallAttitude& attitude,
                                     const bearing::BallEquilibrium& ball, double speed);

}  // namespace raceway::friction::contact
