#include "bearing/displaced_bearing.h"

#include <algorithm>
#include <cmath>

#include "bearing/ball_report.h"
#include "bearing/validation.h"

namespace raceway::bearing {
namespace {

constexpr double least_ball_scale = 1e-3;  // [N]
constexpr int most_ball_steps = 60;
/// Where rounding stops a ball short of the tolerance, this is enough [1].
constexpr double near_enough = 1e-8;

double distance_to(Plane p) { return std::sqrt(p.axial * p.axial + p.radial * p.radial); }

}  // namespace

DisplacedBearing::DisplacedBearing(const Bearing& bearing, double speed, const RingShift& shift,
                                   const EquilibriumOptions& options)
    : bearing_(&bearing),
      options_(options),
      unshifted_(unloaded_point(bearing, options)),
      circle_(ball_circle(bearing, {}, options)),
      one_shoulder_(bearing.geometry().contact_angle > 0.0) {
  require_between("speed", speed, 0.0, 1e6 * rpm, rpm, "rpm");
  unshifted_.ball.full_centrifugal = full_centrifugal(bearing, speed);
  unshifted_.ball_scale = std::max(least_ball_scale, 0.2 * unshifted_.ball.full_centrifugal);
  unshifted_.load_scale = unshifted_.ball_scale * circle_.count;
  circle_.symmetry = Symmetry::none;
  set_shift(shift);
  model_ = ball_model(point_, options);
  balls_.resize(static_cast<std::size_t>(circle_.count));
}

void DisplacedBearing::set_shift(const RingShift& shift) {
  axial_shift_ = shift.axial;
  point_ = unshifted_;
  point_.free.radial += shift.radial;
  point_.ball.inner_radius += shift.inner_length;
  point_.ball.outer_radius += shift.outer_length;
}

Plane DisplacedBearing::thrown_ball() const {
  const double force = 0.2 * point_.ball.full_centrifugal;
  return {0.0, point_.ball.outer_radius + std::pow(force / point_.ball.outer_stiffness, 2.0 / 3.0)};
}

Plane DisplacedBearing::resting_ball(Plane centre) const {
  const StaticBall b = static_ball<double>(point_.ball, point_.springs, centre);
  return b.load > 0.0 ? b.ball_centre : thrown_ball();
}

InnerContact DisplacedBearing::contact_at(Plane centre) const {
  const bool apart = one_shoulder_ && centre.axial < 0.0 &&
                     centre.radial < point_.ball.inner_radius + distance_to(thrown_ball());
  return apart ? InnerContact::lost : InnerContact::automatic;
}

template <BallModel model>
bool DisplacedBearing::balance(Plane centre, InnerContact contact, const GivenRotation* given,
                               Plane& ball) const {
  BallStep<double> step, trial_step;
  Plane x = ball;
  BallShare<double> now = ball_share<model>(point_, centre, x, contact, step, given);
  for (int i = 0; i < most_ball_steps; ++i) {
    if (!std::isfinite(now.imbalance)) return false;
    const double residual = std::sqrt(now.imbalance);
    double fraction = 1.0;
    Plane next;
    BallShare<double> trial;
    for (int halving = 0;; ++halving) {
      next = {x.axial + fraction * step.own[0], x.radial + fraction * step.own[1]};
      // The centrifugal force keeps every ball on the outer race; a step that leaves it is cut.
      const double least = point_.ball.outer_radius + 0.1 * step.outer_approach;
      const double length = distance_to(next);
      if (length < least) next = {next.axial * least / length, next.radial * least / length};
      trial = ball_share<model>(point_, centre, next, contact, trial_step, given);
      if (trial.imbalance <= (halving == 0 ? 4.0 : 1.0) * now.imbalance || halving == 10) break;
      fraction *= 0.5;
    }
    const bool better = trial.imbalance < now.imbalance;
    if (residual <= options_.tolerance || (!better && residual <= near_enough)) {
      // The step that this look gives is taken too, near rounding.
      ball = better ? next : x;
      return true;
    }
    x = next;
    now = trial;
    step = trial_step;
  }
  return false;
}

template <BallModel model>
bool DisplacedBearing::find(Plane centre, InnerContact contact, const GivenRotation* given,
                            Plane& ball) const {
  if (placed_ && balance<model>(centre, contact, given, ball)) return true;
  for (const Plane start : {resting_ball(centre), thrown_ball()}) {
    ball = start;
    if (balance<model>(centre, contact, given, ball)) return true;
  }
  // Followed from rest in speed squared, the steps as long as Newton allows.
  DisplacedBearing slower = *this;
  constexpr double shortest = 1e-4;
  ball = resting_ball(centre);
  for (double share = 0.0, step = 0.1; share < 1.0;) {
    const double next = std::min(1.0, share + step);
    slower.point_.ball.full_centrifugal = next * point_.ball.full_centrifugal;
    Plane trial = ball;
    if (slower.balance<model>(centre, contact, given, trial)) {
      ball = trial;
      share = next;
      step *= 2.0;
    } else if ((step *= 0.3) < shortest) {
      return false;
    }
  }
  return true;
}

template <BallModel model>
bool DisplacedBearing::hold_as(const Vector5& scaled) {
  ring_ = scaled;
  // Moved within the plane of x and y, balls k and Z - k are alike.
  const bool in_plane = scaled[2] == 0.0 && scaled[3] == 0.0 && circle_.rotations.empty();
  circle_.symmetry = in_plane ? Symmetry::mirror : Symmetry::none;
  RingSums<AllCoordinates, double> sums;
  BallShare<double> share{};
  Plane last_centre{unset, unset};
  for (int k = 0; k < circle_.used(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Plane centre = groove_centre<AllCoordinates>(point_, circle_, ring_.data(), k);
    if (centre == last_centre && circle_.rotations.size() <= 1) {
      balls_[i] = balls_[i - 1];
    } else {
      const InnerContact contact = contact_at(centre);
      BallStep<double> step;
      if constexpr (model == BallModel::at_rest) {
        share =
            contact == InnerContact::lost
                ? BallShare<double>{}
                : ball_share<model>(point_, centre, balls_[i], contact, step, circle_.rotation(k));
      } else {
        if (!find<model>(centre, contact, circle_.rotation(k), balls_[i])) {
          placed_ = false;
          return false;
        }
        share = ball_share<model>(point_, centre, balls_[i], contact, step, circle_.rotation(k));
      }
      last_centre = centre;
    }
    sums.add(circle_, k, share);
  }
  complete(circle_, sums);
  for (auto k = static_cast<std::size_t>(circle_.used()); k < balls_.size(); ++k)
    balls_[k] = balls_[balls_.size() - k];
  placed_ = true;
  for (int r = 0; r < 5; ++r) {
    const double row = r < 3 ? 1.0 : point_.lever;
    force_[r] = sums.carried[r] * row;
    for (int c = 0; c < 5; ++c)
      stiffness_(r, c) = sums.stiffness[r][c] * row * (c < 3 ? 1.0 : point_.lever);
  }
  return force_.allFinite() && stiffness_.allFinite();
}

bool DisplacedBearing::hold(const Vector5& displacement) {
  Vector5 scaled = displacement;
  scaled[0] += axial_shift_;
  scaled.tail<2>() *= point_.lever;
  return with_model(model_,
                    [&](auto model) { return this->hold_as<decltype(model)::value>(scaled); });
}

template <BallModel model>
void DisplacedBearing::report_into(BearingEquilibrium& result) const {
  const double diameter = bearing_->geometry().ball_diameter;
  const auto kept = result.balls.reset(circle_.count, circle_.symmetry);
  double worst = 0.0;
  for (int k = 0; k < circle_.used(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Plane centre = groove_centre<AllCoordinates>(point_, circle_, ring_.data(), k);
    const InnerContact contact = contact_at(centre);
    BallStep<double> step;
    BallShare<double> share{};
    if (model != BallModel::at_rest || contact != InnerContact::lost)
      share = ball_share<model>(point_, centre, balls_[i], contact, step, circle_.rotation(k));
    worst = std::max(worst, share.imbalance);
    kept[i] = ball_equilibrium(
        ball_report<model == BallModel::at_rest>(share.forces, centre, balls_[i], diameter),
        circle_.azimuth[k]);
    if (const GivenRotation* given = circle_.rotation(k)) result.rotations.push_back(*given);
  }
  result.report.residual = std::sqrt(worst);
}

BearingEquilibrium DisplacedBearing::equilibrium() const {
  BearingEquilibrium e;
  e.displacement = ring_;
  e.displacement.tail<2>() /= point_.lever;
  e.stiffness = stiffness_;
  with_model(model_, [&](auto model) { this->report_into<decltype(model)::value>(e); });
  e.report.status = SolveStatus::converged;
  return e;
}

std::vector<BearingEquilibrium> bearings_in_set(const Arrangement& arrangement,
                                                const ArrangementCondition& condition,
                                                const ArrangementEquilibrium& equilibrium,
                                                const EquilibriumOptions& options) {
  std::vector<BearingEquilibrium> all(arrangement.bearings().size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RingShift shift = condition.shifts.empty() ? RingShift{} : condition.shifts[i];
    DisplacedBearing held(*arrangement.bearings()[i].bearing, condition.speed, shift,
                          options_of_bearing(options, i));
    Vector5 place = Vector5::Zero();
    place[0] = equilibrium.bearings.at(i).displacement - shift.axial;
    if (held.hold(place)) all[i] = held.equilibrium();
  }
  return all;
}

}  // namespace raceway::bearing
