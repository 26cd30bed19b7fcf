#pragma once

#include <cmath>
#include <cstddef>

#include "bearing/bearing_equilibrium.h"
#include "friction/contact/contact_shape.h"
#include "friction/contact/film.h"
#include "friction/contact/film_traction.h"
#include "friction/contact/hysteresis.h"
#include "friction/contact/oil.h"
#include "friction/contact/rolling.h"
#include "friction/skf.h"

namespace raceway::friction::contact {

/// Parameters of the contact law in addition to the bearing and the oil. The valid range of each
/// parameter is the range of the corresponding key in a model file.
struct ContactLaw {
  Inlet supply = Inlet::limited;
  double replenishment = 0.0;  ///< replenishment constant K_rs [1]; 0: no starvation
  /// Distance from the contact centre to the edge of the oil in the inlet, divided by the
  /// semi-minor axis b of the contact [1]. starvation_factors() calls this ratio m. NaN means a
  /// flooded film.
  double inlet_over_b = unset;
  double boundary_friction = 0.10;         ///< friction coefficient μ of asperities [1]
  double limiting_traction = 0.06;         ///< limiting traction coefficient Γ of the film [1]
  double eyring_stress = 5.0 * MPa;        ///< Eyring stress τ0 of the oil [Pa]
  double composite_roughness = 0.05 * um;  ///< composite roughness Rq of race and ball [m]
  AsperityLaw asperities;
  double rolling_factor = 1.0;     ///< factor that multiplies the rolling resistance of the oil [1]
  double hysteresis_factor = 1.0;  ///< factor that multiplies the hysteresis loss [1]
};

/// Film, slip and losses of one loaded contact.
struct ContactFriction {
  Film film;                    ///< film thickness [m]
  double film_ratio = 0.0;      ///< film ratio Λ [1]
  double asperity_share = 1.0;  ///< share φ of the load that asperities carry [1]
  double peak_pressure = 0.0;   ///< [Pa]
  double semi_major_axis = 0.0, semi_minor_axis = 0.0;  ///< half axes a, b [m]
  double spin = 0.0;                                    ///< spin ω_s [rad/s]
  double rolling_speed = 0.0;  ///< ω_roll, rolling of the ball relative to the race [rad/s]
  double mean_slip = 0.0;      ///< mean sliding speed, weighted with the pressure [m/s]
  /// Mean friction coefficient: integral of the shear stress over the contact, divided by the
  /// contact load [1].
  double mean_friction = 0.0;
  double sliding = 0.0, rolling = 0.0, hysteresis = 0.0;  ///< power losses [W]
  bool converged = true;  ///< true if the solution for the slip converged
  [[nodiscard]] double power() const { return sliding + rolling + hysteresis; }
};

/// Shape, oil properties and contact law of all contacts of one race.
struct RaceFriction {
  ContactShape shape;
  OilState oil;
  ContactLaw law;
  double ball_diameter;  ///< D [m]
  double supply_factor;  ///< replenishment factor φ_rs [1]

  /// Returns the friction of one contact with the load Q > 0 [N]. The film is computed at the
  /// surface speed of `motion` times the factor `film_speed` [1]. The factor 0 means standstill:
  /// asperities carry the whole load, and the oil has no rolling resistance. The power divided by
  /// the shaft speed is then the friction moment in the limit of zero speed. `centre` contains the
  /// start value for the slip at the contact centre and receives the solution, see film_traction().
  [[nodiscard]] ContactFriction contact(double load, const ContactMotion& motion, double film_speed,
                                        double& centre) const {
    const ContactFriction c = film(load, motion, film_speed);
    return contact(c, load, motion, film_speed,
                   film_traction(ellipse(c, load, motion), shear(c, motion), centre));
  }
  [[nodiscard]] ContactFriction contact(double load, const ContactMotion& motion,
                                        double film_speed = 1.0) const {
    double centre = usual_centre;
    return contact(load, motion, film_speed, centre);
  }

  /// Returns the friction of a contact. `c` is the result of film(), and `traction` the result of
  /// film_traction() or of another solver for the slip.
  [[nodiscard]] ContactFriction contact(ContactFriction c, double load, const ContactMotion& motion,
                                        double film_speed, const Traction& traction) const {
    c.sliding = traction.power;
    c.mean_friction = traction.mean_friction;
    c.mean_slip = traction.mean_slip * film_speed;
    c.converged = traction.converged;
    const RollingInlet inlet = inlet_of(load, motion, film_speed);
    const double force = rolling_force({.inlet = inlet,
                                        .radius_across = shape.radius_across,
                                        .semi_major_axis = c.semi_major_axis,
                                        .semi_minor_axis = c.semi_minor_axis,
                                        .second_integral = shape.second_integral},
                                       law.supply);
    c.rolling = law.rolling_factor * supply_factor * thermal_rolling_factor(loading_of(inlet)) *
                rolling_power(force, inlet.speed);
    c.hysteresis = law.hysteresis_factor * std::abs(motion.rolling) *
                   hysteresis_moment(ball_diameter, load, shape.radius_across / shape.radius_along,
                                     0.5 * shape.modulus);
    return c;
  }

  /// Returns film, contact size, pressure and speeds of a contact, without slip and losses.
  [[nodiscard]] ContactFriction film(double load, const ContactMotion& motion,
                                     double film_speed) const {
    ContactFriction c;
    c.semi_major_axis = shape.unit_major_axis * std::cbrt(load);
    c.semi_minor_axis = c.semi_major_axis / shape.ellipse_ratio;
    c.peak_pressure = 1.5 * load / (pi * c.semi_major_axis * c.semi_minor_axis);
    c.spin = motion.spin * film_speed;
    c.rolling_speed = motion.rolling * film_speed;
    const RollingInlet inlet = inlet_of(load, motion, film_speed);
    const Film flooded = isothermal_film(inlet, shape.ellipse_ratio);
    const double thermal = thermal_film_factor(loading_of(inlet));
    const StarvationFactors starved =
        std::isnan(law.inlet_over_b) || !(flooded.central > 0.0)
            ? StarvationFactors{}
            : starvation_factors(flooded, inlet.radius_along, c.semi_minor_axis, law.inlet_over_b);
    c.film = {.central = flooded.central * thermal * starved.central,
              .minimum = flooded.minimum * thermal * starved.minimum};
    c.film_ratio = contact::film_ratio(c.film, law.composite_roughness);
    c.asperity_share = contact::asperity_share(c.film_ratio, law.asperities);
    return c;
  }

  [[nodiscard]] SlidingEllipse ellipse(const ContactFriction& c, double load,
                                       const ContactMotion& motion) const {
    return {.load = load,
            .semi_major_axis = c.semi_major_axis,
            .semi_minor_axis = c.semi_minor_axis,
            .differential = motion.rolling / (2.0 * shape.pressed_radius),
            .spin = motion.spin};
  }

  [[nodiscard]] FilmShear shear(const ContactFriction& c, const ContactMotion& motion) const {
    return {.viscosity = Roelands(oil.viscosity, oil.pressure_viscosity),
            .film = c.film.central,
            .eyring_stress = law.eyring_stress,
            .limiting_traction = law.limiting_traction,
            .asperity_share = c.asperity_share,
            .boundary_friction = law.boundary_friction,
            .small_speed = 1e-6 * std::abs(motion.surface_speed)};
  }

 private:
  [[nodiscard]] RollingInlet inlet_of(double load, const ContactMotion& motion,
                                      double film_speed) const {
    return {.viscosity = oil.viscosity,
            .pressure_viscosity = oil.pressure_viscosity,
            .speed = std::abs(motion.surface_speed) * film_speed,
            .modulus = shape.modulus,
            .radius_along = shape.radius_along,
            .load = load};
  }

  [[nodiscard]] double loading_of(const RollingInlet& inlet) const {
    return thermal_loading(oil.viscosity, oil.viscosity_slope, inlet.speed, oil.conductivity);
  }
};

/// Friction of a bearing, summed over its contacts. Losses are moments on the shaft: power divided
/// by shaft speed.
struct BearingFriction {
  struct Parts {
    double sliding = 0.0, rolling = 0.0, hysteresis = 0.0;  ///< [N m]
    [[nodiscard]] double sum() const { return sliding + rolling + hysteresis; }
  };
  Parts inner, outer;                  ///< losses at the inner and outer race [N m]
  double smallest_film = unset;        ///< thinnest film of all contacts, h_min [m]
  double smallest_film_ratio = unset;  ///< smallest film ratio Λ of all contacts [1]
  bool converged = false;
  [[nodiscard]] double moment() const { return inner.sum() + outer.sum(); }  ///< [N m]

  /// Returns the result for a bearing without equilibrium: all moments are NaN.
  [[nodiscard]] static BearingFriction none() {
    BearingFriction f;
    f.inner = f.outer = {unset, unset, unset};
    return f;
  }
  /// Adds the friction of several equal contacts to `parts`, the sums for one race. `contacts` is
  /// the number of these contacts, and `speed` the shaft speed [rad/s].
  void add(const ContactFriction& c, double contacts, double speed, Parts& parts) {
    const double share = contacts / speed;
    parts.sliding += share * c.sliding;
    parts.rolling += share * c.rolling;
    parts.hysteresis += share * c.hysteresis;
    smallest_film = std::fmin(smallest_film, c.film.minimum);
    smallest_film_ratio = std::fmin(smallest_film_ratio, c.film_ratio);
    converged = converged && c.converged;
  }
};

/// Returns the shape, oil properties and contact law for the contacts of one race. The
/// replenishment factor is computed at the shaft speed `speed` [rad/s].
[[nodiscard]] inline RaceFriction race_friction(const bearing::Bearing& bearing, bearing::Race race,
                                                const OilState& oil, const ContactLaw& law,
                                                double speed) {
  const bearing::BearingGeometry& g = bearing.geometry();
  return {.shape = contact_shape(bearing, race),
          .oil = oil,
          .law = law,
          .ball_diameter = g.ball_diameter,
          .supply_factor = law.replenishment > 0.0
                               ? replenishment_factor(
                                     law.replenishment, speed, oil.kinematic_viscosity,
                                     RingSize{g.bore, g.outer_diameter}, skf_angular_contact.K_Z)
                               : 1.0};
}

/// Returns the surface, rolling and spin speeds at both contacts of one ball in equilibrium. A ball
/// without contact at the inner race is under outer control.
[[nodiscard]] inline BallMotion ball_motion(const bearing::BearingGeometry& g,
                                            const bearing::BallEquilibrium& ball,
                                            bearing::RaceControl control, double speed) {
  const bool held = ball.inner_load > 0.0;
  // Without contact at the inner race, the inner contact angle is NaN. The outer contact angle is
  // used instead, as in BearingEquilibrium::speeds().
  const double inner = held ? ball.inner_contact_angle : ball.outer_contact_angle;
  const bearing::BallRotation r =
      bearing::ball_rotation(held ? control : bearing::RaceControl::outer, inner,
                             ball.outer_contact_angle, g.diameter_ratio(), speed);
  return ball_motion(g, r, inner, ball.outer_contact_angle, speed);
}

/// Friction at both contacts of a ball. If the ball does not touch the inner race, `inner` contains
/// no valid result.
struct ContactsOfBall {
  ContactFriction inner, outer;
};

/// Sums the friction of all loaded contacts of a bearing at the shaft speed `turning` [rad/s].
/// `contacts(k, ball)` returns the friction at both contacts of ball k in Balls::distinct(). The
/// function calls `look(k, race, friction, weight)` for each loaded contact of these balls;
/// `weight` is the number of balls in the bearing that are equal to ball k.
template <typename Contacts, typename Look>
[[nodiscard]] BearingFriction sum_over_contacts(const bearing::BearingEquilibrium& equilibrium,
                                                double turning, Contacts&& contacts, Look&& look) {
  BearingFriction sum;
  sum.converged = true;
  const bearing::Balls& balls = equilibrium.balls;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    if (!(ball.outer_load > 0.0)) continue;
    const double weight = balls.weight(k);
    const ContactsOfBall c = contacts(k, ball);
    if (ball.inner_load > 0.0) {
      look(k, bearing::Race::inner, c.inner, weight);
      sum.add(c.inner, weight, turning, sum.inner);
    }
    look(k, bearing::Race::outer, c.outer, weight);
    sum.add(c.outer, weight, turning, sum.outer);
  }
  return sum;
}

/// Friction of all contacts of a bearing in equilibrium.
///
///   M = Σ (sliding + rolling + hysteresis)/ω       over the balls, at both races
///
/// ω is the shaft speed. The power lost in a contact is assigned to the race of this contact. The
/// sum of the moments at a race, times the shaft speed, is therefore the heat generated at the ring
/// with this race. The function assumes race control without gyroscopic creep; use
/// balanced_friction() for balls without race control.
/// Source:   the laws in friction/contact. The formula for M follows from the power balance of the
///           bearing.
/// Domain:   speed >= 0; at standstill, the result is the limit as the speed approaches zero. The
///           moments are NaN without a converged equilibrium.
/// Accuracy: the code agrees with the laws to rounding error, except for the sliding loss, whose
///           accuracy is given at film_traction(). The friction of a bearing at speed is uncertain
///           by +-40 %, because oil supply and inlet heating are not well known. Flooded inlets
///           give 32 to 55 % more friction than inlets with limited oil supply. The computed ratio
///           of the friction of two bearings is much more accurate than each of the two values.
/// The argument `look` is described at sum_over_contacts().
template <typename Look>
[[nodiscard]] BearingFriction bearing_friction(const bearing::Bearing& bearing,
                                               const bearing::BearingEquilibrium& equilibrium,
                                               bearing::RaceControl control, double speed,
                                               const OilState& oil, const ContactLaw& law,
                                               Look&& look) {
  if (!equilibrium.report.converged()) return BearingFriction::none();
  const RaceFriction inner = race_friction(bearing, bearing::Race::inner, oil, law, speed);
  const RaceFriction outer = race_friction(bearing, bearing::Race::outer, oil, law, speed);
  const double turning = speed > 0.0 ? speed : 1.0, film_speed = speed > 0.0 ? 1.0 : 0.0;
  double inner_centre = usual_centre, outer_centre = usual_centre;  // passed from ball to ball
  const auto contacts = [&](std::size_t, const bearing::BallEquilibrium& ball) {
    const BallMotion motion = ball_motion(bearing.geometry(), ball, control, turning);
    ContactsOfBall c;
    if (ball.inner_load > 0.0)
      c.inner = inner.contact(ball.inner_load, motion.inner, film_speed, inner_centre);
    c.outer = outer.contact(ball.outer_load, motion.outer, film_speed, outer_centre);
    return c;
  };
  return sum_over_contacts(equilibrium, turning, contacts, look);
}

/// Default of `look` in bearing_friction(): does nothing.
inline constexpr auto no_look = [](std::size_t, bearing::Race, const ContactFriction&, double) {};

[[nodiscard]] inline BearingFriction bearing_friction(
    const bearing::Bearing& bearing, const bearing::BearingEquilibrium& equilibrium,
    bearing::RaceControl control, double speed, const OilState& oil, const ContactLaw& law) {
  return bearing_friction(bearing, equilibrium, control, speed, oil, law, no_look);
}

}  // namespace raceway::friction::contact
