#include "bearing/ring_system.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace raceway::bearing {
namespace {

Symmetry symmetry_of(const OperatingPoint& p) {
  if (p.radial_load_z != 0.0 || p.moment_y != 0.0) return Symmetry::none;
  if (p.radial_load != 0.0 || p.moment_z != 0.0) return Symmetry::mirror;
  return Symmetry::thrust;
}

/// Sums over the circle for balls that are all alike, where one ball (ψ = 0) was added Z-fold.
void complete_thrust(Vector5& carried, Vector5& ahead, Matrix5& k) {
  // At ψ = 0: k(0,0) = Z t00, k(1,1) = Z t11, k(1,4) = -Z t10, k(4,1) = -Z t21, k(4,4) = Z t20.
  const double k00 = k(0, 0), k11 = 0.5 * k(1, 1), k14 = 0.5 * k(1, 4), k41 = 0.5 * k(4, 1),
               k44 = 0.5 * k(4, 4);
  k.setZero();
  k(0, 0) = k00;
  k(1, 1) = k(2, 2) = k11;
  k(3, 3) = k(4, 4) = k44;
  k(1, 4) = k14;
  k(2, 3) = -k14;
  k(4, 1) = k41;
  k(3, 2) = -k41;
  carried.tail<4>().setZero();
  ahead.tail<4>().setZero();
}

/// What cancels between the two halves of a load in the x-y plane.
void drop_odd(Vector5& carried, Vector5& ahead, Matrix5& k) {
  for (const int odd : {2, 3}) {
    carried[odd] = ahead[odd] = 0.0;
    for (const int even : {0, 1, 4}) k(odd, even) = k(even, odd) = 0.0;
  }
}

}  // namespace

RingSystem::RingSystem(const Bearing& bearing, const OperatingPoint& point,
                       const EquilibriumOptions& options, RingWorkspace& workspace)
    : bearing_(bearing), options_(options), workspace_(workspace) {
  const BearingGeometry& geometry = bearing.geometry();
  lever_ = geometry.inner_groove_centre_radius();
  moment_arm_ratio_ = geometry.inner_conformity * geometry.ball_diameter / lever_;
  const double distance = geometry.groove_centre_distance();
  free_ = {distance * std::sin(geometry.contact_angle),
           distance * std::cos(geometry.contact_angle) - 0.5 * geometry.radial_clearance};
  set_point(point);
}

void RingSystem::set_point(const OperatingPoint& p) {
  symmetry_ = symmetry_of(p);
  constants_ = ball_constants(bearing_, p.speed, options_.race_control, options_.gyroscopic_moment);
  constants_.gyroscopic *= couple;
  at_rest_ = constants_.full_centrifugal == 0.0;
  load_ << p.axial_load, p.radial_load, p.radial_load_z, p.moment_y / lever_, p.moment_z / lever_;
  if (options_.tilt == Tilt::locked) load_.tail<2>().setZero();
  load_scale_ = load_.cwiseAbs().maxCoeff();
  ball_scale_ = load_scale_ / geometry().ball_count;
  const int z = geometry().ball_count;
  balls_used_ = symmetry_ == Symmetry::thrust ? 1 : symmetry_ == Symmetry::mirror ? z / 2 + 1 : z;
}

bool RingSystem::newton(RingState& state) {
  Assembly &now = workspace_.now, &trial = workspace_.trial;
  RingState& trial_state = workspace_.trial_state;
  assemble(state, now);
  for (int i = 0; i < newton_limit && iterations_ < options_.max_iterations; ++i) {
    if (now.residual <= options_.tolerance) return true;
    if (!std::isfinite(now.merit)) return fail(SolveStatus::not_finite);
    Vector5 step;
    if (!ring_step(step)) return fail(SolveStatus::singular);
    ++iterations_;
    double fraction = 1.0;
    const double longest = step.head<3>().cwiseAbs().maxCoeff();
    const double allowed = 0.5 * (constants_.inner_radius + constants_.outer_radius);
    if (longest > allowed) fraction = allowed / longest;
    for (int halving = 0;; ++halving) {
      advance(state, step, fraction, trial_state);
      assemble(trial_state, trial);
      // A ball that changes between contact and none may raise the residual on the way.
      const double accept = halving == 0 ? 4.0 : 1.0;
      if (trial.merit <= accept * now.merit) break;
      if (halving == 6) break;
      fraction *= 0.5;
    }
    const bool stalled =
        trial.residual < 1e3 * options_.tolerance && trial.merit > 0.25 * now.merit;
    std::swap(state.ring, trial_state.ring);
    std::swap(state.balls, trial_state.balls);
    std::swap(now, trial);
    if (stalled && now.residual <= 10.0 * options_.tolerance) return true;
  }
  return now.residual <= options_.tolerance || fail(SolveStatus::no_equilibrium);
}

bool RingSystem::fail(SolveStatus why) {
  if (!attempted_ || why == SolveStatus::no_equilibrium) failure_ = why;
  attempted_ = true;
  return false;
}

void RingSystem::advance(const RingState& from, const Vector5& step, double fraction,
                         RingState& to) const {
  to.ring = from.ring + fraction * step;
  to.balls.resize(from.balls.size());
  if (at_rest_) return;
  for (std::size_t k = 0; k < from.balls.size(); ++k) {
    const Plane da = groove_step(step, k);
    const Assembly::Ball& e = workspace_.now.balls[k];
    const Plane x = from.balls[k];
    Plane next{x.axial + fraction * (e.own[0] + e.follow[0] * da.axial + e.follow[1] * da.radial),
               x.radial + fraction * (e.own[1] + e.follow[2] * da.axial + e.follow[3] * da.radial)};
    // The centrifugal force keeps every ball on the outer race; a step that leaves it is cut.
    const double before = std::sqrt(x.axial * x.axial + x.radial * x.radial);
    const double least = constants_.outer_radius + 0.1 * (before - constants_.outer_radius);
    const double length = std::sqrt(next.axial * next.axial + next.radial * next.radial);
    if (length < least) {
      next.axial *= least / length;
      next.radial *= least / length;
    }
    to.balls[k] = next;
  }
}

Plane RingSystem::groove_step(const Vector5& step, std::size_t k) const {
  const double c = bearing_.cos_azimuth()[k], s = bearing_.sin_azimuth()[k];
  return {step[0] + step[3] * s - step[4] * c, step[1] * c + step[2] * s};
}

Plane RingSystem::groove_centre(const Vector5& ring, std::size_t k) const {
  const Plane moved = groove_step(ring, k);
  return {free_.axial + moved.axial, free_.radial + moved.radial};
}

template <int N>
bool RingSystem::solve_active(const std::array<int, N>& active, Vector5& step) const {
  Eigen::Matrix<double, N, N> k;
  Eigen::Matrix<double, N, 1> f;
  for (int i = 0; i < N; ++i) {
    const auto row = active[static_cast<std::size_t>(i)];
    f[i] = workspace_.now.missing_ahead[row];
    for (int j = 0; j < N; ++j)
      k(i, j) = workspace_.now.stiffness(row, active[static_cast<std::size_t>(j)]);
  }
  const Eigen::Matrix<double, N, 1> x = k.partialPivLu().solve(f);
  step.setZero();
  for (int i = 0; i < N; ++i) step[active[static_cast<std::size_t>(i)]] = x[i];
  return x.allFinite();
}

bool RingSystem::ring_step(Vector5& step) const {
  const bool tilts = options_.tilt == Tilt::free;
  switch (symmetry_) {
    case Symmetry::thrust:
      return solve_active<1>({0}, step);
    case Symmetry::mirror:
      return tilts ? solve_active<3>({0, 1, 4}, step) : solve_active<2>({0, 1}, step);
    case Symmetry::none:
      break;
  }
  return tilts ? solve_active<5>({0, 1, 2, 3, 4}, step) : solve_active<3>({0, 1, 2}, step);
}

double RingSystem::weight(std::size_t k) const {
  if (symmetry_ == Symmetry::none) return 1.0;
  const auto z = static_cast<std::size_t>(geometry().ball_count);
  if (symmetry_ == Symmetry::thrust) return static_cast<double>(z);
  return k == 0 || 2 * k == z ? 1.0 : 2.0;
}

Plane RingSystem::thrown_ball() const {
  const double force = 0.2 * constants_.full_centrifugal;
  return {0.0, constants_.outer_radius + std::pow(force / constants_.outer_stiffness, 2.0 / 3.0)};
}

BallShare RingSystem::static_share(Plane centre, Assembly::Ball& ball) const {
  const StaticBall b = static_ball(constants_, centre);
  ball.forces = {};
  ball.forces.inner_load = ball.forces.outer_load = b.load;
  return {.force = {b.force.axial, b.force.radial, b.force.axial},
          .gain = {0.0, 0.0, 0.0},
          .tangent = {b.f_a[0], b.f_a[1], b.f_a[2], b.f_a[3], b.f_a[0], b.f_a[1]},
          .imbalance = 0.0};
}

template <RaceControl control>
[[gnu::always_inline]] inline BallShare RingSystem::moving_share(Plane centre, Plane x,
                                                                 InnerContact contact,
                                                                 Assembly::Ball& e) const {
  const BallBalance b =
      ball_balance_under<control>(constants_, centre, x, moment_arm_ratio_, contact);
  e.forces = b;
  // follow = -r_x⁻¹ r_a, own = -r_x⁻¹ r
  const double inv = -1.0 / (b.r_x[0] * b.r_x[3] - b.r_x[1] * b.r_x[2]);
  e.own[0] = inv * (b.r_x[3] * b.imbalance.axial - b.r_x[1] * b.imbalance.radial);
  e.own[1] = inv * (b.r_x[0] * b.imbalance.radial - b.r_x[2] * b.imbalance.axial);
  e.follow[0] = inv * (b.r_x[3] * b.r_a[0] - b.r_x[1] * b.r_a[2]);
  e.follow[1] = inv * (b.r_x[3] * b.r_a[1] - b.r_x[1] * b.r_a[3]);
  e.follow[2] = inv * (b.r_x[0] * b.r_a[2] - b.r_x[2] * b.r_a[0]);
  e.follow[3] = inv * (b.r_x[0] * b.r_a[3] - b.r_x[2] * b.r_a[1]);
  BallShare share;
  // Under outer control the moment's row is the axial one.
  constexpr int rows = control == RaceControl::inner ? 3 : 2;
  for (int j = 0; j < rows; ++j) {
    const double fx0 = b.f_x[2 * j], fx1 = b.f_x[2 * j + 1];
    share.gain[j] = fx0 * e.own[0] + fx1 * e.own[1];
    share.tangent[2 * j] = b.f_a[2 * j] + fx0 * e.follow[0] + fx1 * e.follow[2];
    share.tangent[2 * j + 1] = b.f_a[2 * j + 1] + fx0 * e.follow[1] + fx1 * e.follow[3];
  }
  if constexpr (rows == 2) {
    share.gain[2] = share.gain[0];
    share.tangent[4] = share.tangent[0];
    share.tangent[5] = share.tangent[1];
  }
  share.force[0] = b.force.axial;
  share.force[1] = b.force.radial;
  share.force[2] = b.moment_force;
  const double scale = ball_scale_ + b.outer_load;
  share.imbalance =
      (b.imbalance.axial * b.imbalance.axial + b.imbalance.radial * b.imbalance.radial) /
      (scale * scale);
  return share;
}

void RingSystem::assemble(const RingState& state, Assembly& a) const {
  Vector5 carried = Vector5::Zero(), ahead = Vector5::Zero();
  Matrix5& stiffness = a.stiffness;
  stiffness.setZero();
  a.balls.resize(balls_used());
  double worst_ball = 0.0, ball_merit = 0.0;
  Plane last_centre{unset, unset}, last_ball{unset, unset};
  BallShare share{};
  for (std::size_t k = 0; k < balls_used(); ++k) {
    const Plane centre = groove_centre(state.ring, k);
    const bool alike = centre == last_centre && state.balls[k] == last_ball && contacts.empty();
    if (alike) {
      a.balls[k] = a.balls[k - 1];
    } else {
      const InnerContact contact = contacts.empty() ? InnerContact::automatic : contacts[k];
      share = at_rest_ ? static_share(centre, a.balls[k])
              : constants_.race_control == RaceControl::outer
                  ? moving_share<RaceControl::outer>(centre, state.balls[k], contact, a.balls[k])
                  : moving_share<RaceControl::inner>(centre, state.balls[k], contact, a.balls[k]);
    }
    last_centre = centre;
    last_ball = state.balls[k];
    worst_ball = std::max(worst_ball, share.imbalance);
    ball_merit += weight(k) * share.imbalance;
    add_ball(k, share, carried, ahead, stiffness);
  }
  if (symmetry_ == Symmetry::thrust) complete_thrust(carried, ahead, stiffness);
  if (symmetry_ == Symmetry::mirror) drop_odd(carried, ahead, stiffness);
  a.missing = load_ - carried;
  a.missing_ahead = load_ - ahead;
  if (options_.tilt == Tilt::locked) a.missing.tail<2>().setZero();
  const double ring = a.missing.cwiseAbs().maxCoeff() / load_scale_;
  a.residual = std::max(ring, std::sqrt(worst_ball));
  a.merit =
      a.missing.squaredNorm() / (load_scale_ * load_scale_) + ball_merit / geometry().ball_count;
}

/// Adds the forces of ball k and its tangent, turned from its plane into the bearing's axes.
void RingSystem::add_ball(std::size_t k, const BallShare& share, Vector5& carried, Vector5& ahead,
                          Matrix5& stiffness) const {
  const double(&f)[3] = share.force;
  const double(&gain)[3] = share.gain;
  const double(&t)[6] = share.tangent;
  const double w = weight(k);
  const double c = bearing_.cos_azimuth()[k], s = bearing_.sin_azimuth()[k];
  const Vector5 axial{1.0, 0.0, 0.0, s, -c};  // ∂A_axial/∂ring; the moment rows alike
  const Vector5 force{w * f[0], w * f[1] * c, w * f[1] * s, w * f[2] * s, -w * f[2] * c};
  const Vector5 more{w * gain[0], w * gain[1] * c, w * gain[1] * s, w * gain[2] * s,
                     -w * gain[2] * c};
  carried += force;
  ahead += force + more;
  const Vector5 by_axial{w * t[0], w * t[2] * c, w * t[2] * s, w * t[4] * s, -w * t[4] * c};
  const Vector5 by_radial{w * t[1], w * t[3] * c, w * t[3] * s, w * t[5] * s, -w * t[5] * c};
  stiffness.col(0) += by_axial;
  stiffness.col(1) += by_radial * c;
  stiffness.col(2) += by_radial * s;
  stiffness.col(3) += by_axial * axial[3];
  stiffness.col(4) += by_axial * axial[4];
}

}  // namespace raceway::bearing
