#include "friction/contact/ball_attitude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "friction/contact/turning_ball.h"

namespace raceway::friction::contact {
namespace {

using bearing::SolveStatus;

constexpr double attitude_tolerance = 1e-10;  // of Σ|τ| [1]
constexpr double attitude_rounding = 1e-8;    // where rounding stops a step short of it [1]
constexpr int most_attitude_steps = 60;
constexpr double film_tolerance = 1e-8;  // on the cage speed that a film was made at [1]
constexpr int most_films = 12;
constexpr std::array smoother{1e4, 1e3, 1e2, 1e1, 1.0};  // than the speed where dry friction turns

/// Newton's method down to the tolerance; false leaves q anywhere.
bool turn(const TurningBall& ball, Slips& q, TurningBall::Look& now, bearing::SolveReport& report) {
  now = ball.look(q);
  for (int i = 0; i < most_attitude_steps; ++i) {
    report.residual = now.largest() / now.size;
    if (report.residual <= attitude_tolerance) return true;
    if (!std::isfinite(report.residual)) {
      report.status = SolveStatus::not_finite;
      return false;
    }
    const Slips s = ball.step(q, now);
    ++report.iterations;
    double fraction = 1.0;
    Slips next;
    TurningBall::Look trial;
    for (int halving = 0;; ++halving) {
      for (std::size_t k = 0; k < 4; ++k) next[k] = q[k] + fraction * s[k];
      trial = ball.look(next);
      if (trial.merit() < (1.0 - 0.1 * fraction) * now.merit() || halving == 8) break;
      fraction *= 0.5;
    }
    if (!(trial.merit() < now.merit())) {
      report.status = SolveStatus::iteration_limit;
      return report.residual <= attitude_rounding;
    }
    q = next;
    now = trial;
  }
  report.status = SolveStatus::iteration_limit;
  return false;
}

/// The same from a start that may be far off: dry friction turns smoothly first.
bool turn_smoothly(TurningBall& ball, Slips& q, TurningBall::Look& now,
                   bearing::SolveReport& report) {
  bool found = false;
  for (const double times : smoother) {
    ball.smooth(times);
    found = turn(ball, q, now, report);
  }
  return found;
}

/// The most balanced of a few pitch angles.
Slips cold_start(const TurningBall& ball) {
  const double outer = ball.outer_control(), inner = ball.inner_control();
  Slips best{};
  double least = std::numeric_limits<double>::infinity();
  for (const double pitch : {0.0, outer, 0.5 * (outer + inner), inner}) {
    const Slips q = ball.rolling(pitch);
    const double merit = ball.look(q).merit();
    if (!(merit < least)) continue;
    least = merit;
    best = q;
  }
  return best;
}

Traction traction_of(const SlipForces& f, const SlipMotion& m, double load) {
  return {.converged = true,
          .slip = {m.along, m.across},
          .power = f.power,
          .spin_moment = f.force[3],
          .mean_friction = f.size / load,
          .mean_slip = f.pressure_slip / load};
}

}  // namespace

BallAttitudes::BallAttitudes(const bearing::Bearing& bearing, double speed, const OilState& oil,
                             const ContactLaw& law)
    : bearing_(&bearing),
      speed_(speed),
      inner_(race_friction(bearing, bearing::Race::inner, oil, law, speed)),
      outer_(race_friction(bearing, bearing::Race::outer, oil, law, speed)) {}

BallAttitude BallAttitudes::on_outer_race(const bearing::BallEquilibrium& ball) const {
  const double angle = ball.outer_contact_angle;
  const bearing::BallRotation r = bearing::ball_rotation(
      bearing::RaceControl::outer, angle, angle, bearing_->geometry().diameter_ratio(), turning());
  BallAttitude a;
  a.cage_speed = a.film_cage_speed = r.cage_speed;
  a.along = r.along;
  a.across = r.across;
  a.orbital = 0.0;
  const ContactMotion m = ball_motion(bearing_->geometry(), r, angle, angle, turning()).outer;
  const ContactFriction film = outer_.film(ball.outer_load, m, film_speed());
  a.outer = film_traction(outer_.ellipse(film, ball.outer_load, m), outer_.shear(film, m));
  a.outer_slip = {a.outer.slip.along, 0.0, m.rolling, 0.0};
  a.inner.converged = true;
  a.inner.power = a.inner.spin_moment = 0.0;
  a.inner_force = 0.0;
  a.outer_force = ball.outer_friction;
  a.shaft_power = 0.0;
  a.report = {.status = SolveStatus::converged, .iterations = 0, .residual = 0.0};
  return a;
}

bool BallAttitudes::press(const bearing::BallEquilibrium& ball, double cage,
                          TurningBall& turned) const {
  bool boundary = false;
  const auto contact = [this, &boundary](const RaceFriction& race, double load,
                                         double surface_speed) {
    const ContactMotion motion{.surface_speed = surface_speed};
    const ContactFriction film = race.film(load, motion, film_speed());
    boundary = boundary || film.asperity_share > 0.1;
    return SlippingContact(race.ellipse(film, load, motion), race.shear(film, motion),
                           race.shape.pressed_radius);
  };
  turned.set_contacts(contact(inner_, ball.inner_load, turned.inner_surface_speed(cage)),
                      contact(outer_, ball.outer_load, turned.outer_surface_speed(cage)));
  return boundary;
}

BallAttitude BallAttitudes::solve_once(const bearing::BallEquilibrium& ball,
                                       const BallAttitude* start) const {
  if (!(ball.inner_load > 0.0)) return on_outer_race(ball);
  // At rest nothing turns fast enough for a gyroscopic moment.
  TurningBall turned(*bearing_, ball, turning(), speed_ > 0.0 ? bearing_->ball_inertia() : 0.0);
  const bool warm = start && start->report.converged() && start->shaft_power > 0.0;
  const double cage = warm ? start->cage_speed : turned.rolling_cage_speed(turned.outer_control());
  const bool boundary = press(ball, cage, turned);
  Slips q = warm ? Slips{start->inner_slip.along, start->outer_slip.along, start->inner_slip.across,
                         start->across * turned.length()}
                 : turned.rolling(boundary ? 0.5 * (turned.outer_control() + turned.inner_control())
                                           : 0.0);
  BallAttitude a;
  TurningBall::Look look;
  if (!turn(turned, q, look, a.report)) {
    q = cold_start(turned);
    if (!turn_smoothly(turned, q, look, a.report)) return a;
  }
  const TurningBall::Speeds v = turned.speeds(q);
  a.cage_speed = v.cage;
  a.film_cage_speed = cage;
  a.along = v.along;
  a.across = v.across;
  a.orbital = v.orbital;
  a.inner_slip = turned.inner_motion(q, v);
  a.outer_slip = turned.outer_motion(q, v);
  a.inner = traction_of(look.inner, a.inner_slip, ball.inner_load);
  a.outer = traction_of(look.outer, a.outer_slip, ball.outer_load);
  a.inner_force = look.inner.force[1];
  a.outer_force = look.outer.force[1];
  a.shaft_power = turned.shaft_power(look.inner);
  a.report.status = SolveStatus::converged;
  return a;
}

BallAttitude BallAttitudes::solve(const bearing::BallEquilibrium& ball,
                                  const BallAttitude* start) const {
  BallAttitude a = solve_once(ball, start);
  int steps = a.report.iterations;
  for (int films = 1; films < most_films && a.report.converged(); ++films) {
    if (std::abs(a.cage_speed - a.film_cage_speed) <= film_tolerance * turning()) break;
    a = solve_once(ball, &a);
    a.report.iterations = steps += a.report.iterations;
  }
  if (a.report.converged() &&
      !(std::abs(a.cage_speed - a.film_cage_speed) <= film_tolerance * turning()))
    a.report.status = SolveStatus::iteration_limit;
  return a;
}

ContactsOfBall BallAttitudes::contacts(const BallAttitude& a,
                                       const bearing::BallEquilibrium& ball) const {
  const BallMotion m = ball_motion(bearing_->geometry(), a, ball, turning());
  const auto contact = [this](const RaceFriction& race, double load, const ContactMotion& motion,
                              const Traction& traction) {
    return race.contact(race.film(load, motion, film_speed()), load, motion, film_speed(),
                        traction);
  };
  ContactsOfBall c;
  if (ball.inner_load > 0.0) c.inner = contact(inner_, ball.inner_load, m.inner, a.inner);
  c.outer = contact(outer_, ball.outer_load, m.outer, a.outer);
  return c;
}

BallMotion ball_motion(const bearing::BearingGeometry& g, const BallAttitude& a,
                       const bearing::BallEquilibrium& ball, double speed) {
  // The inner contact angle of a ball off the race is no number.
  const double outer = ball.outer_contact_angle;
  const double inner = ball.inner_load > 0.0 ? ball.inner_contact_angle : outer;
  return ball_motion(g,
                     bearing::BallRotation{.cage_speed = a.cage_speed,
                                           .along = a.along,
                                           .across = a.across,
                                           .inner_spin_speed = std::abs(a.inner_slip.spin),
                                           .outer_spin_speed = std::abs(a.outer_slip.spin)},
                     inner, outer, speed);
}

}  // namespace raceway::friction::contact
