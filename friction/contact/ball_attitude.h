#pragma once

#include <cmath>

#include "bearing/bearing_equilibrium.h"
#include "friction/contact/contact_friction.h"
#include "friction/contact/slip_forces.h"

namespace raceway::friction::contact {

/// Rotation of a ball that follows from traction at both contacts, without race control, and the
/// resulting slip, forces and power. At standstill, speeds and powers are values for a shaft speed
/// of 1 rad/s.
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

/// Finds the rotation of the balls of one bearing at one speed and state of the oil.
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
/// gradient of a potential that is convex in these unknowns. The gyroscopic moment adds an
/// antisymmetric term to the matrix of derivatives. Because the potential is convex, exactly one
/// ball rotation exists for a given cage speed, and every Newton step leads towards this rotation.
/// If dry friction changes direction too sharply for Newton's method, the solver first smooths this
/// change and then removes the smoothing.
///
/// Source:   derived from the slip field of traction.h. Race control is not assumed: in a full film
///           the rotation axis tilts until the gyroscopic moment vanishes (β near 0); under
///           boundary friction the rotation approaches race control.
/// Domain:   speed >= 0; at standstill, the result is the limit as the speed approaches zero. The
///           balls are loaded at least by the outer race. A ball without contact at the inner race
///           rotates as under outer control.
/// Accuracy: the forces on a ball balance to 1e-9 of the sum of |τ|; the power input equals the
///           power loss to a relative 1e-8. Film and rolling resistance are computed at the
///           resulting cage speed. The effect of rolling resistance on the rotation of a ball is
///           neglected.
class BallAttitudes {
 public:
  BallAttitudes(const bearing::Bearing& bearing, double speed, const OilState& oil,
                const ContactLaw& law);

  /// Returns the rotation of a ball for the loads and contact angles in `ball`. `start` is an
  /// initial guess, for example the rotation of a neighbouring ball or of this ball at another
  /// load.
  [[nodiscard]] BallAttitude solve(const bearing::BallEquilibrium& ball,
                                   const BallAttitude* start = nullptr) const;
  /// Returns the rotation of a ball with films at the cage speed of `start`, or at the cage speed
  /// of outer control if there is no converged `start`. solve() repeats this step until the cage
  /// speed of the films agrees with the cage speed of the result.
  [[nodiscard]] BallAttitude solve_once(const bearing::BallEquilibrium& ball,
                                        const BallAttitude* start = nullptr) const;

  /// Returns the friction at both contacts of a ball with this rotation.
  [[nodiscard]] ContactsOfBall contacts(const BallAttitude& attitude,
                                        const bearing::BallEquilibrium& ball) const;

  [[nodiscard]] const RaceFriction& race(bearing::Race race) const {
    return race == bearing::Race::inner ? inner_ : outer_;
  }
  /// Shaft speed that solve() uses [rad/s]: the speed of the bearing, or 1 rad/s at standstill.
  [[nodiscard]] double turning() const { return speed_ > 0.0 ? speed_ : 1.0; }
  /// Factor on the speed for the film thickness [1]: 0 at standstill, else 1.
  [[nodiscard]] double film_speed() const { return speed_ > 0.0 ? 1.0 : 0.0; }

 private:
  [[nodiscard]] BallAttitude on_outer_race(const bearing::BallEquilibrium& ball) const;
  /// Computes the ellipse and the shear law of both contacts of `ball`, with the film thickness at
  /// this cage speed, and passes them to `turned`. Returns true if asperities carry more than a
  /// tenth of the load of at least one contact.
  bool press(const bearing::BallEquilibrium& ball, double cage_speed, TurningBall& turned) const;

  const bearing::Bearing* bearing_;
  double speed_;
  RaceFriction inner_, outer_;
};

/// Returns the surface, rolling and spin speeds at both contacts of a ball with this rotation.
/// `speed` is the shaft speed [rad/s].
[[nodiscard]] BallMotion ball_motion(const bearing::BearingGeometry& geometry,
                                     const BallAttitude& attitude,
                                     const bearing::BallEquilibrium& ball, double speed);

}  // namespace raceway::friction::contact
