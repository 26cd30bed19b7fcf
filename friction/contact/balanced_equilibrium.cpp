#include "friction/contact/balanced_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bearing/ball_equilibrium.h"

namespace raceway::friction::contact {
namespace {

using bearing::GivenRotation;
using bearing::SolveStatus;

constexpr double balance_tolerance = 1e-8;     // of the load on a ball [1]
constexpr double film_speed_tolerance = 1e-7;  // of the cage speed that a film is made at [1]
constexpr int most_passes = 80;

GivenRotation given_rotation(const BallAttitude& a, const bearing::BallEquilibrium& ball, double g,
                             double turning) {
  const double pitch = a.pitch_angle();
  GivenRotation r{.cos_pitch = std::cos(pitch),
                  .sin_pitch = std::sin(pitch),
                  .inner_friction = a.inner_force,
                  .outer_friction = a.outer_force,
                  .inner_load = ball.inner_load};
  r.creep = a.cage_speed / turning - bearing::rolling_cage_ratio(r.cos_pitch, r.sin_pitch,
                                                                 ball.inner_contact_angle,
                                                                 ball.outer_contact_angle, g);
  return r;
}

/// `share` of the way from one rotation to another.
GivenRotation between(const GivenRotation& from, const GivenRotation& to, double share) {
  const auto mix = [share](double a, double b) { return a + share * (b - a); };
  GivenRotation r{.cos_pitch = mix(from.cos_pitch, to.cos_pitch),
                  .sin_pitch = mix(from.sin_pitch, to.sin_pitch),
                  .creep = mix(from.creep, to.creep),
                  .inner_friction = mix(from.inner_friction, to.inner_friction),
                  .outer_friction = mix(from.outer_friction, to.outer_friction),
                  .inner_load = mix(from.inner_load, to.inner_load)};
  const double length = std::hypot(r.cos_pitch, r.sin_pitch);
  r.cos_pitch /= length;
  r.sin_pitch /= length;
  return r;
}

/// Those of the distinct balls for all balls of a bearing, or one for all.
void give(const std::vector<GivenRotation>& distinct, const bearing::Balls& balls,
          std::vector<GivenRotation>& all) {
  all.clear();
  const std::size_t wanted = distinct.size() == 1 ? 1 : balls.size();
  for (std::size_t k = 0; k < wanted; ++k) all.push_back(distinct[balls.twin(k)]);
}

}  // namespace

bool TurningBalls::turn(std::span<const bearing::BallEquilibrium> balls, double ball_scale) {
  const double g = bearing_->geometry().diameter_ratio(), turning = attitudes_of_.turning();
  const double full = bearing::full_centrifugal(*bearing_, speed_);
  change_ = films_ = 0.0;
  std::vector<BallAttitude> next(balls.size());
  const bool known = attitudes_.size() == balls.size();
  std::vector<GivenRotation> found(balls.size());
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const bearing::BallEquilibrium& ball = balls[k];
    if (!(ball.outer_load > 0.0)) continue;  // loose, at rest
    next[k] = attitudes_of_.solve_once(ball, known ? &attitudes_[k] : nullptr);
    if (!next[k].report.converged()) {
      status_ = next[k].report.status;
      return false;
    }
    if (!(ball.inner_load > 0.0)) continue;
    const double m = next[k].cage_speed / turning;
    const double weight = ball_scale > 0.0 ? std::min(1.0, ball.inner_load / ball_scale) : 1.0;
    films_ = std::max(films_, weight * std::abs(m - next[k].film_cage_speed / turning));
    const double off = std::max({std::abs(full * m * m - ball.centrifugal_force),
                                 std::abs(next[k].inner_force - ball.inner_friction),
                                 std::abs(next[k].outer_force - ball.outer_friction)});
    change_ = std::max(change_, off / (ball_scale + ball.outer_load));
    found[k] = given_rotation(next[k], ball, g, turning);
  }
  follow(found);
  attitudes_ = std::move(next);
  status_ = SolveStatus::converged;
  return true;
}

void TurningBalls::follow(const std::vector<GivenRotation>& found) {
  share_ =
      change_ > 0.7 * last_change_ ? std::max(0.05, 0.5 * share_) : std::min(1.0, 1.2 * share_);
  last_change_ = change_;
  if (rotations_.size() != found.size()) {
    rotations_ = found;
    return;
  }
  for (std::size_t k = 0; k < found.size(); ++k)
    rotations_[k] = between(rotations_[k], found[k], share_);
}

bool TurningBalls::settled() const {
  return (change_ <= balance_tolerance || speed_ == 0.0) && films_ <= film_speed_tolerance;
}

BalancedEquilibrium solve_balanced_equilibrium(const bearing::Bearing& bearing,
                                               const bearing::OperatingPoint& point,
                                               const OilState& oil, const ContactLaw& law,
                                               const bearing::EquilibriumOptions& options,
                                               const bearing::BearingEquilibrium* neighbour) {
  BalancedEquilibrium b;
  bearing::EquilibriumOptions with = options;
  with.race_control = bearing::RaceControl::outer;
  std::vector<GivenRotation> rotations;
  if (neighbour && !neighbour->rotations.empty())
    give(neighbour->rotations, neighbour->balls, rotations);
  with.rotations = rotations;
  TurningBalls turning(bearing, point.speed, oil, law);
  const double ball_scale = std::max({std::abs(point.axial_load), std::abs(point.radial_load),
                                      std::abs(point.radial_load_z)}) /
                            static_cast<double>(bearing.geometry().ball_count);
  bearing::BearingEquilibrium& e = b.equilibrium;
  int steps = 0;
  b.report.status = SolveStatus::iteration_limit;
  for (int pass = 0; pass < most_passes; ++pass) {
    b.report.iterations = pass + 1;
    e = neighbour ? solve_bearing_equilibrium(bearing, point, with, *neighbour)
                  : solve_bearing_equilibrium(bearing, point, with);
    e.report.iterations = steps += e.report.iterations;
    if (!e.report.converged()) {
      b.report.status = e.report.status;
      return b;
    }
    if (!turning.turn(e.balls.distinct(), ball_scale)) {
      b.report.status = turning.status();
      break;
    }
    b.report.residual = turning.change();
    if (turning.settled()) {
      b.report.status = SolveStatus::converged;
      e.rotations = turning.rotations();
      b.attitudes = turning.attitudes();
      return b;
    }
    give(turning.rotations(), e.balls, rotations);
    with.rotations = rotations;
    neighbour = &e;
  }
  bearing::SolveReport refused = e.report;
  refused.status = b.report.status;
  e = {};
  e.report = refused;
  return b;
}

bearing::ArrangementEquilibrium solve_balanced_arrangement(
    const bearing::Arrangement& arrangement, const bearing::ArrangementCondition& condition,
    std::span<const OilState> oils, const ContactLaw& law,
    const bearing::EquilibriumOptions& options, const bearing::ArrangementEquilibrium* neighbour) {
  const auto bearings = arrangement.bearings();
  if (oils.size() != 1 && oils.size() != bearings.size())
    throw std::invalid_argument(
        "oils: give one oil state for each bearing, or one for all bearings");
  std::vector<TurningBalls> turning;
  turning.reserve(bearings.size());
  for (std::size_t i = 0; i < bearings.size(); ++i)
    turning.emplace_back(*bearings[i].bearing, condition.speed, oils[oils.size() == 1 ? 0 : i],
                         law);
  bearing::EquilibriumOptions with = options;
  with.race_control = bearing::RaceControl::outer;
  std::vector<GivenRotation> rotations;
  if (neighbour) rotations = neighbour->rotations();
  with.rotations = rotations;
  bearing::ArrangementEquilibrium e, last;
  int steps = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    e = solve_arrangement(arrangement, condition, with, neighbour);
    e.report.iterations = steps += e.report.iterations;
    if (!e.report.converged()) return e;
    bool settled = true;
    rotations.clear();
    for (std::size_t i = 0; i < bearings.size(); ++i) {
      const bearing::BearingInSet& b = e.bearings[i];
      const double balls = bearings[i].bearing->geometry().ball_count;
      if (!turning[i].turn({&b.ball, 1}, b.axial_load / balls)) {
        bearing::ArrangementEquilibrium refused;
        refused.report = e.report;
        refused.report.status = turning[i].status();
        return refused;
      }
      settled = settled && turning[i].settled();
      rotations.push_back(turning[i].rotations().front());
    }
    if (settled) {
      for (std::size_t i = 0; i < bearings.size(); ++i) e.bearings[i].rotation = rotations[i];
      return e;
    }
    with.rotations = rotations;
    last = std::move(e);
    neighbour = &last;
  }
  bearing::ArrangementEquilibrium refused;
  refused.report = last.report;
  refused.report.status = SolveStatus::iteration_limit;
  return refused;
}

}  // namespace raceway::friction::contact
