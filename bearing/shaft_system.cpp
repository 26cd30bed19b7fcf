#include "bearing/shaft_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raceway::bearing {
namespace {

constexpr double least_force_scale = 1.0;  // [N], of an arrangement that nothing loads

double length_of(Plane p) { return std::sqrt(p.axial * p.axial + p.radial * p.radial); }

void add(const BearingShare& one, BearingShare& sum) {
  sum.force += one.force;
  sum.gain += one.gain;
  sum.stiffness += one.stiffness;
}

}  // namespace

ShaftSystem::ShaftSystem(const Arrangement& arrangement, const EquilibriumOptions& options)
    : arrangement_(arrangement), options_(options), seat_(arrangement.seat()) {
  members_.resize(arrangement.bearings().size());
}

void ShaftSystem::set_condition(const ArrangementCondition& c, double speed_share,
                                double load_share) {
  const auto bearings = arrangement_.bearings();
  const double speed = c.speed * std::sqrt(speed_share);
  const bool shifted = !c.shifts.empty();
  at_rest_ = speed == 0.0;
  load_ = load_share * arrangement_.direction() * c.external_load;
  elongation_ = load_share * arrangement_.direction() * c.elongation;
  force_scale_ = std::max({arrangement_.preload(), std::abs(load_), least_force_scale});
  longest_step_ = std::numeric_limits<double>::infinity();
  reference_stiffness_ = 0.0;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const MountedBearing& mounted = bearings[i];
    Member& m = members_[i];
    m.like_last =
        i > 0 && i != arrangement_.front_count() && mounted.bearing == bearings[i - 1].bearing &&
        mounted.offset == bearings[i - 1].offset && (!shifted || c.shifts[i] == c.shifts[i - 1]) &&
        (options_.rotations.empty() || options_.rotations[i] == options_.rotations[i - 1]);
    if (m.like_last) {
      m = members_[i - 1];
      m.like_last = true;
      continue;
    }
    const BearingGeometry& g = mounted.bearing->geometry();
    const double distance = g.groove_centre_distance();
    m.constants =
        ball_constants(*mounted.bearing, speed, options_.race_control, options_.gyroscopic_moment);
    m.free = {distance * std::sin(g.contact_angle), distance * std::cos(g.contact_angle)};
    m.offset = mounted.offset;
    m.count = g.ball_count;
    if (shifted) {
      m.offset += load_share * c.shifts[i].axial;
      m.free.radial += load_share * c.shifts[i].radial;
      m.constants.inner_radius += load_share * c.shifts[i].inner_length;
      m.constants.outer_radius += load_share * c.shifts[i].outer_length;
    }
    longest_step_ = std::min(longest_step_, 0.5 * distance);
    // Of the order of the bearing's stiffness under its share of the load.
    const double sine = std::sin(g.contact_angle);
    const double ball_load = force_scale_ / (m.count * sine);
    const double contact = std::min(m.constants.inner_stiffness, m.constants.outer_stiffness);
    reference_stiffness_ =
        std::max(reference_stiffness_,
                 m.count * sine * sine * 0.75 * std::cbrt(contact * contact * ball_load));
  }
}

double ShaftSystem::displacement(const ShaftState& state, std::size_t i) const {
  const double side = i < arrangement_.front_count()
                          ? arrangement_.displacement(Side::front) - state.shaft
                          : state.rear;
  return side + members_[i].offset;
}

Plane ShaftSystem::groove_centre(const ShaftState& state, std::size_t i) const {
  return {members_[i].free.axial + displacement(state, i), members_[i].free.radial};
}

Plane ShaftSystem::thrown_ball(std::size_t i) const {
  const BallConstants& c = members_[i].constants;
  const double force = 0.2 * c.full_centrifugal;
  return {0.0, c.outer_radius + std::pow(force / c.outer_stiffness, 2.0 / 3.0)};
}

double ShaftSystem::rear_force(const ShaftState& state) const {
  if (members_.size() > arrangement_.front_count()) return now_.rear.force;
  return arrangement_.preload() + seat_.hardness * (state.shaft - elongation_);
}

BearingShare ShaftSystem::share(const ShaftState& state, std::size_t i) const {
  const Member& m = members_[i];
  const Plane centre = groove_centre(state, i);
  BearingShare s;
  // A groove of an angular-contact bearing has one shoulder: rings that have come this far apart do
  // not meet on the other side. Rings without radial play do, around the bottom of the groove.
  const bool apart =
      centre.axial < 0.0 && centre.radial < m.constants.inner_radius + length_of(thrown_ball(i));
  if (at_rest_) {
    if (apart) return s;
    const StaticBall b = static_ball(m.constants, centre);
    s.force = m.count * b.force.axial;
    s.stiffness = m.count * b.f_a[0];
    s.ball.inner_load = s.ball.outer_load = b.load;
    return s;
  }
  // The moment is not asked for.
  const BallBalance b =
      ball_balance(m.constants, centre, state.balls[i], 0.0,
                   apart ? InnerContact::lost : InnerContact::automatic, rotation(i));
  s.ball = b;
  const double inv = -1.0 / (b.r_x[0] * b.r_x[3] - b.r_x[1] * b.r_x[2]);
  s.own[0] = inv * (b.r_x[3] * b.imbalance.axial - b.r_x[1] * b.imbalance.radial);
  s.own[1] = inv * (b.r_x[0] * b.imbalance.radial - b.r_x[2] * b.imbalance.axial);
  s.follow[0] = inv * (b.r_x[3] * b.r_a[0] - b.r_x[1] * b.r_a[2]);
  s.follow[1] = inv * (b.r_x[0] * b.r_a[2] - b.r_x[2] * b.r_a[0]);
  s.force = m.count * b.force.axial;
  s.gain = m.count * (b.f_x[0] * s.own[0] + b.f_x[1] * s.own[1]);
  s.stiffness = m.count * (b.f_a[0] + b.f_x[0] * s.follow[0] + b.f_x[1] * s.follow[1]);
  const double scale = force_scale_ / m.count + b.outer_load;
  s.imbalance = (b.imbalance.axial * b.imbalance.axial + b.imbalance.radial * b.imbalance.radial) /
                (scale * scale);
  return s;
}

void ShaftSystem::assemble(const ShaftState& state, ShaftAssembly& a) const {
  a.bearings.resize(members_.size());
  a.front = a.rear = {};
  double worst = 0.0, merit = 0.0;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    a.bearings[i] = i > 0 && alike(state, i) ? a.bearings[i - 1] : share(state, i);
    add(a.bearings[i], i < arrangement_.front_count() ? a.front : a.rear);
    worst = std::max(worst, a.bearings[i].imbalance);
    merit += a.bearings[i].imbalance;
  }
  const bool tandem = members_.size() == arrangement_.front_count();
  const double moved = state.shaft - elongation_;
  if (tandem) {
    a.rear.force = arrangement_.preload() + seat_.hardness * moved;
    a.rear.stiffness = seat_.hardness;
    a.seat_imbalance = 0.0;
  } else {
    a.seat_imbalance =
        seat_.softness * (a.rear.force - arrangement_.preload()) -
        seat_.hardness * (moved - (state.rear - arrangement_.displacement(Side::rear)));
  }
  a.shaft_imbalance = a.front.force - a.rear.force + load_;
  const double scale = std::max({force_scale_, a.front.force, a.rear.force});
  const double shaft = a.shaft_imbalance / scale;
  // As a force: what it would take to move the rear set by it.
  const double seat = a.seat_imbalance * reference_stiffness_ /
                      (seat_.hardness + seat_.softness * reference_stiffness_) / scale;
  a.residual = std::max({std::abs(shaft), std::abs(seat), std::sqrt(worst)});
  a.merit = shaft * shaft + seat * seat + merit;
}

double ShaftSystem::stiffness() const {
  const double rear = now_.rear.stiffness;
  if (members_.size() == arrangement_.front_count()) return now_.front.stiffness + rear;
  const double seat = seat_.hardness + seat_.softness * rear;
  return now_.front.stiffness + (seat > 0.0 ? rear * seat_.hardness / seat : 0.0);
}

bool ShaftSystem::step(Step& s) const {
  const ShaftAssembly& a = now_;
  const bool tandem = members_.size() == arrangement_.front_count();
  const double front = a.front.force + a.front.gain;
  const double rear = a.rear.force + a.rear.gain;
  const double seat_imbalance = a.seat_imbalance + seat_.softness * a.rear.gain;
  const double seat = tandem ? 1.0 : seat_.hardness + seat_.softness * a.rear.stiffness;
  const double through = tandem ? 1.0 : seat_.hardness / seat;
  // Where nothing touches, the loads push towards contact.
  const double reach = 0.1 * longest_step_;
  if (!(seat > 0.0)) {
    s = {0.0, std::copysign(reach, -seat_imbalance)};
    return seat_imbalance != 0.0;
  }
  const double push =
      front - rear + load_ + (tandem ? 0.0 : a.rear.stiffness * seat_imbalance / seat);
  const double stiffness = a.front.stiffness + a.rear.stiffness * through;
  if (stiffness > 0.0) {
    s.shaft = push / stiffness;
  } else if (stiffness == 0.0 && push != 0.0) {
    s.shaft = std::copysign(reach, push);
  } else {
    return false;
  }
  s.rear = tandem ? 0.0 : (seat_.hardness * s.shaft - seat_imbalance) / seat;
  return std::isfinite(s.shaft) && std::isfinite(s.rear);
}

void ShaftSystem::advance(const ShaftState& from, const Step& step, double fraction,
                          ShaftState& to) const {
  to.shaft = from.shaft + fraction * step.shaft;
  to.rear = from.rear + fraction * step.rear;
  to.balls.resize(from.balls.size());
  if (at_rest_) return;
  for (std::size_t i = 0; i < from.balls.size(); ++i) {
    const BearingShare& e = now_.bearings[i];
    const double da = i < arrangement_.front_count() ? -step.shaft : step.rear;
    const Plane x = from.balls[i];
    Plane next{x.axial + fraction * (e.own[0] + e.follow[0] * da),
               x.radial + fraction * (e.own[1] + e.follow[1] * da)};
    // The centrifugal force keeps every ball on the outer race; a step that leaves it is cut.
    const double radius = members_[i].constants.outer_radius;
    const double least = radius + 0.1 * (length_of(x) - radius);
    const double length = length_of(next);
    if (length < least) {
      next.axial *= least / length;
      next.radial *= least / length;
    }
    to.balls[i] = next;
  }
}

bool ShaftSystem::newton(ShaftState& state) {
  constexpr int most_steps = 40;
  assemble(state, now_);
  for (int i = 0; i < most_steps && !exhausted(); ++i) {
    if (now_.residual <= options_.tolerance) return true;
    if (!std::isfinite(now_.merit)) return fail(SolveStatus::not_finite);
    Step s{};
    if (!step(s)) return fail(SolveStatus::singular);
    ++iterations_;
    double fraction = 1.0;
    const double longest = std::max(std::abs(s.shaft), std::abs(s.rear));
    if (longest > longest_step_) fraction = longest_step_ / longest;
    for (int halving = 0;; ++halving) {
      advance(state, s, fraction, trial_state_);
      assemble(trial_state_, trial_);
      // A bearing that changes between contact and none may raise the residual on the way.
      const double accept = halving == 0 ? 4.0 : 1.0;
      if (trial_.merit <= accept * now_.merit || halving == 6) break;
      fraction *= 0.5;
    }
    const bool stalled =
        trial_.residual < 1e3 * options_.tolerance && trial_.merit > 0.25 * now_.merit;
    std::swap(state, trial_state_);
    std::swap(now_, trial_);
    if (stalled && now_.residual <= 10.0 * options_.tolerance) return true;
  }
  return now_.residual <= options_.tolerance || fail(SolveStatus::no_equilibrium);
}

bool ShaftSystem::fail(SolveStatus why) {
  if (!attempted_ || why == SolveStatus::no_equilibrium) failure_ = why;
  attempted_ = true;
  return false;
}

void ShaftSystem::restart() {
  iterations_ = 0;
  failure_ = SolveStatus::no_equilibrium;
  attempted_ = false;
}

}  // namespace raceway::bearing
