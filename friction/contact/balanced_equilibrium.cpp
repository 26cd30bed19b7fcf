#include "friction/contact/balanced_equilibrium.h"

#include <algorithm>
#include <cmath>

namespace raceway::friction::contact {
namespace {

using bearing::GivenRotation;
using bearing::SolveStatus;

constexpr double balance_tolerance = 1e-8;     // of the load on a ball [1]
constexpr double film_speed_tolerance = 1e-7;  // of the cage speed that a film is made at [1]
constexpr int most_passes = 40;

/// m of a ball that rolls without slip at both contacts about an axis at pitch β; see
/// GivenRotation.
double rolling_cage_ratio(const bearing::BallEquilibrium& ball, double g, double pitch) {
  const double p =
      (1.0 - g * std::cos(ball.inner_contact_angle)) * std::cos(ball.outer_contact_angle - pitch);
  const double q =
      (1.0 + g * std::cos(ball.outer_contact_angle)) * std::cos(ball.inner_contact_angle - pitch);
  return p / (p + q);
}

GivenRotation given_rotation(const BallAttitude& a, const bearing::BallEquilibrium& ball, double g,
                             double speed) {
  const double pitch = a.pitch_angle();
  return {.cos_pitch = std::cos(pitch),
          .sin_pitch = std::sin(pitch),
          .creep = a.cage_speed / speed - rolling_cage_ratio(ball, g, pitch),
          .inner_friction = a.inner_force,
          .outer_friction = a.outer_force,
          .inner_load = ball.inner_load};
}

}  // namespace

BalancedEquilibrium solve_balanced_equilibrium(const bearing::Bearing& bearing,
                                               const bearing::OperatingPoint& point,
                                               const OilState& oil, const ContactLaw& law,
                                               const bearing::EquilibriumOptions& options) {
  BalancedEquilibrium b;
  bearing::EquilibriumOptions with = options;
  with.race_control = bearing::RaceControl::outer;
  with.rotations = {};
  const BallAttitudes attitudes(bearing, point.speed, oil, law);
  const double g = bearing.geometry().diameter_ratio();
  const double full =
      0.5 * bearing.ball_mass() * bearing.geometry().pitch_diameter * point.speed * point.speed;
  const auto count = static_cast<std::size_t>(bearing.geometry().ball_count);
  const double ball_scale = std::max({std::abs(point.axial_load), std::abs(point.radial_load),
                                      std::abs(point.radial_load_z)}) /
                            static_cast<double>(count);
  std::vector<GivenRotation> rotations;
  b.equilibrium = bearing::solve_bearing_equilibrium(bearing, point, with);
  for (int pass = 0; pass < most_passes; ++pass) {
    b.report.iterations = pass + 1;
    if (!b.equilibrium.report.converged()) {
      b.report.status = b.equilibrium.report.status;
      return b;
    }
    const auto balls = b.equilibrium.balls.distinct();
    std::vector<BallAttitude> next(balls.size());
    double change = 0.0, films = 0.0;
    rotations.resize(balls.size() == 1 ? 1 : count);
    for (std::size_t k = 0; k < balls.size(); ++k) {
      next[k] = attitudes.solve_once(balls[k], b.attitudes.empty() ? nullptr : &b.attitudes[k]);
      if (!next[k].report.converged()) {
        b.report.status = next[k].report.status;
        return b;
      }
      const double m = next[k].cage_speed / attitudes.turning();
      rotations[k] = {};
      if (!(balls[k].inner_load > 0.0)) continue;
      const double weight = std::min(1.0, balls[k].inner_load / ball_scale);
      films = std::max(films, weight * std::abs(m - next[k].film_cage_speed / attitudes.turning()));
      const double off = std::max({std::abs(full * m * m - balls[k].centrifugal_force),
                                   std::abs(next[k].inner_force - balls[k].inner_friction),
                                   std::abs(next[k].outer_force - balls[k].outer_friction)});
      change = std::max(change, off / (ball_scale + balls[k].outer_load));
      rotations[k] = given_rotation(next[k], balls[k], g, attitudes.turning());
    }
    b.attitudes = std::move(next);
    b.report.residual = change;
    if ((change <= balance_tolerance || point.speed == 0.0) && films <= film_speed_tolerance) {
      b.report.status = SolveStatus::converged;
      return b;
    }
    for (std::size_t k = balls.size(); k < rotations.size(); ++k)
      rotations[k] = rotations[count - k];
    with.rotations = rotations;
    b.equilibrium = bearing::solve_bearing_equilibrium(bearing, point, with, b.equilibrium);
  }
  b.report.status = SolveStatus::iteration_limit;
  return b;
}

BearingFriction bearing_friction(const bearing::Bearing& bearing,
                                 const BalancedEquilibrium& balanced, double speed,
                                 const OilState& oil, const ContactLaw& law) {
  if (!balanced.report.converged()) return BearingFriction::none();
  const BallAttitudes races(bearing, speed, oil, law);
  const RaceFriction &inner = races.race(bearing::Race::inner),
                     &outer = races.race(bearing::Race::outer);
  const double turning = races.turning(), film_speed = races.film_speed();
  BearingFriction sum;
  sum.converged = true;
  const bearing::Balls& balls = balanced.equilibrium.balls;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    const BallAttitude& a = balanced.attitudes[k];
    if (!(ball.outer_load > 0.0)) continue;
    const BallMotion m = ball_motion(bearing.geometry(), a, ball, turning);
    const double alike = balls.weight(k);
    const auto contact = [&](const RaceFriction& race, double load, const ContactMotion& motion,
                             const Traction& traction) {
      const ContactFriction film = race.film(load, motion, film_speed);
      return race.contact(film, load, motion, film_speed, traction);
    };
    if (ball.inner_load > 0.0)
      sum.add(contact(inner, ball.inner_load, m.inner, a.inner), alike, turning, sum.inner);
    sum.add(contact(outer, ball.outer_load, m.outer, a.outer), alike, turning, sum.outer);
  }
  return sum;
}

}  // namespace raceway::friction::contact
