#pragma once

#include <utility>
#include <vector>

#include "bearing/linear_solve.h"
#include "bearing/ring_balance.h"

namespace raceway::bearing {

struct NewtonLimits {
  /// Limit of the residual [1]. The residual is the largest scaled imbalance. The imbalance of the
  /// ring is divided by RingPoint::load_scale. The imbalance of a ball is divided by the sum of
  /// RingPoint::ball_scale and the load Qo of the ball at the outer race.
  double tolerance;
  int steps;  ///< largest number of Newton steps in one lane
  /// Factor by which a full step may raise the merit. The merit is the sum of the squares of the
  /// scaled ring imbalances, plus the mean of the squares of the scaled ball imbalances. The merit
  /// can rise when a ball gains or loses contact.
  double rise = 4.0;
};

/// Progress of the lanes (one operating point in each lane, see lanes.h). For each lane, at most
/// one of the masks `converged`, `not_finite`, `singular` and `exhausted` is true.
template <typename T>
struct NewtonProgress {
  /// True if the trial state was accepted; the iteration continues unless another mask is true.
  Mask<T> taken;
  Mask<T> converged;  ///< true if the residual is within the tolerance or near the rounding error
  Mask<T> not_finite, singular, exhausted;
};

/// Newton's method for ring and balls together, with one operating point in each lane. Lanes can
/// start and finish at different times. The result of a lane does not depend on the other lanes.
///
/// A step leads from the accepted state to a trial state, which pass() accepts or rejects. A step
/// moves the ring by at most half the distance of the groove centres. A full step may raise the
/// merit by the factor NewtonLimits::rise, because a ball may gain or lose contact. If the merit
/// rises more, the step is halved until the merit does not rise. After six halvings, the step is
/// accepted even if the merit rises. When a lane converges, use its trial state as the result. The
/// trial state is one Newton step beyond the accepted state, so its error is near the rounding
/// error. `steps` does not include this last step.
template <typename T>
class RingNewton {
 public:
  RingPoint<T> point;
  T ring[5];
  std::vector<PlaneOf<T>> balls;
  T trial_ring[5];  ///< trial state, evaluated by the next pass()
  std::vector<PlaneOf<T>> trial_balls;
  T steps = T(0.0);     ///< number of steps since the start
  T residual = T(0.0);  ///< largest scaled imbalance at `ring` and `balls` [1]

  /// Marks the trial state of lane i as a starting state. The next pass() accepts a starting state
  /// without a test of the merit, and does not count the start as a step.
  void begin(std::size_t i) {
    set_lane(fresh_, i, 1.0);
    set_lane(steps, i, 0.0);
  }

  void resize(std::size_t used) {
    for (auto* v : {&balls, &trial_balls}) v->resize(used);
    for (auto* v : {&now_, &trial_}) v->resize(used);
  }

  /// Evaluates the trial state of every lane, and accepts or rejects it. Then computes the next
  /// trial state: a new step, or half of the rejected step.
  template <BallModel model, class C>
  NewtonProgress<T> pass(const BallCircle& circle, const NewtonLimits& limits,
                         const InnerContact* contacts = nullptr);

 private:
  template <BallModel model, class C>
  void assemble(const BallCircle& circle, const InnerContact* contacts);
  template <class C>
  void take(const Mask<T>& taken, int used);
  template <BallModel model, class C>
  void advance(const BallCircle& circle);

  std::vector<BallStep<T>> now_, trial_;
  T trial_force_[5], trial_stiffness_[5][5];  // unbalanced force after the balls' steps; stiffness
  T trial_residual_, trial_merit_;
  T fresh_ = T(1.0), merit_ = T(0.0), fraction_ = T(1.0), halvings_ = T(0.0);
  T step_[5] = {T(0.0), T(0.0), T(0.0), T(0.0), T(0.0)};
};

template <typename T>
template <BallModel model, class C>
[[gnu::always_inline]] inline void RingNewton<T>::assemble(const BallCircle& circle,
                                                           const InnerContact* contacts) {
  using std::abs, std::max, std::sqrt;
  RingSums<C, T> sums;
  T worst_ball(0.0), ball_merit(0.0);
  BallShare<T> share;
  PlaneOf<T> last_centre{T(unset), T(unset)}, last_ball = last_centre;
  const int used = circle.used();
  for (int k = 0; k < used; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const PlaneOf<T> centre = groove_centre<C>(point, circle, trial_ring, k);
    bool alike = false;
    // A ball with the same position as the previous ball is not computed again. At a thrust start,
    // all balls have equal positions.
    if constexpr (is_scalar<T>)
      alike = centre == last_centre && trial_balls[i] == last_ball && !contacts &&
              circle.rotations.size() <= 1;
    if (alike) {
      trial_[i] = trial_[i - 1];
    } else {
      const InnerContact contact = contacts ? contacts[k] : InnerContact::automatic;
      share =
          ball_share<model>(point, centre, trial_balls[i], contact, trial_[i], circle.rotation(k));
      last_centre = centre;
      last_ball = trial_balls[i];
    }
    worst_ball = max(worst_ball, share.imbalance);
    ball_merit = ball_merit + circle.weight(k) * share.imbalance;
    sums.add(circle, k, share);
  }
  T largest(0.0), squares(0.0);
  for (int i = 0; i < C::count; ++i) {
    const T missing = point.load[C::at[i]] - sums.carried[i];
    largest = max(largest, abs(missing));
    squares = squares + missing * missing;
    trial_force_[i] = point.load[C::at[i]] - sums.ahead[i];
    for (int j = 0; j < C::count; ++j) trial_stiffness_[i][j] = sums.stiffness[i][j];
  }
  const T inv_scale = 1.0 / point.load_scale;
  trial_residual_ = max(largest * inv_scale, sqrt(worst_ball));
  trial_merit_ = squares * inv_scale * inv_scale + ball_merit * (1.0 / circle.count);
}

template <typename T>
template <class C>
[[gnu::always_inline]] inline void RingNewton<T>::take(const Mask<T>& taken, int used) {
  residual = select(taken, trial_residual_, residual);
  merit_ = select(taken, trial_merit_, merit_);
  for (const int i : C::at) ring[i] = select(taken, trial_ring[i], ring[i]);
  if (all(taken)) {
    std::swap(balls, trial_balls);
    std::swap(now_, trial_);
    return;
  }
  if (!any(taken)) return;
  for (std::size_t k = 0; k < static_cast<std::size_t>(used); ++k) {
    balls[k].axial = select(taken, trial_balls[k].axial, balls[k].axial);
    balls[k].radial = select(taken, trial_balls[k].radial, balls[k].radial);
    BallStep<T>&to = now_[k], &from = trial_[k];
    for (int j = 0; j < 2; ++j) to.own[j] = select(taken, from.own[j], to.own[j]);
    for (int j = 0; j < 4; ++j) to.follow[j] = select(taken, from.follow[j], to.follow[j]);
    to.outer_approach = select(taken, from.outer_approach, to.outer_approach);
  }
}

template <typename T>
template <BallModel model, class C>
[[gnu::always_inline]] inline void RingNewton<T>::advance(const BallCircle& circle) {
  using std::sqrt;
  for (const int i : C::at) trial_ring[i] = ring[i] + fraction_ * step_[i];
  if constexpr (model == BallModel::at_rest) return;
  const T outer_radius = point.ball.outer_radius;
  const int used = circle.used();
  for (int k = 0; k < used; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const PlaneOf<T> da = groove_step<C>(circle, step_, k);
    const BallStep<T>& e = now_[i];
    const PlaneOf<T> x = balls[i];
    PlaneOf<T> next{
        x.axial + fraction_ * (e.own[0] + e.follow[0] * da.axial + e.follow[1] * da.radial),
        x.radial + fraction_ * (e.own[1] + e.follow[2] * da.axial + e.follow[3] * da.radial)};
    // The centrifugal force keeps every ball on the outer race, so a step that leaves the race is
    // shortened.
    const T least = outer_radius + 0.1 * e.outer_approach;
    const T squared = next.axial * next.axial + next.radial * next.radial;
    const Mask<T> leaves = squared < least * least;
    if (any(leaves)) {
      const T cut = select(leaves, least / sqrt(squared), T(1.0));
      next.axial = next.axial * cut;
      next.radial = next.radial * cut;
    }
    trial_balls[i] = next;
  }
}

template <typename T>
template <BallModel model, class C>
NewtonProgress<T> RingNewton<T>::pass(const BallCircle& circle, const NewtonLimits& limits,
                                      const InnerContact* contacts) {
  using std::abs, std::max, std::min;
  assemble<model, C>(circle, contacts);
  const Mask<T> fresh = fresh_ != T(0.0);
  const T accept = select(halvings_ == T(0.0), T(limits.rise), T(1.0));
  NewtonProgress<T> progress;
  progress.taken = fresh || trial_merit_ <= accept * merit_ || halvings_ == T(6.0);
  // Accepts a residual near the rounding error. Under a very small load, the rounding error is
  // larger than the tolerance.
  const T near = min(max(T(10.0 * limits.tolerance), point.rounding), T(0.1 * largest_load_error));
  const Mask<T> stalled = !fresh && trial_residual_ <= near && trial_merit_ > 0.25 * merit_;
  take<C>(progress.taken, circle.used());
  progress.converged = progress.taken && (residual <= T(limits.tolerance) || stalled);
  const Mask<T> open = progress.taken && !progress.converged;
  progress.exhausted = open && steps >= T(limits.steps);
  progress.not_finite = open && !progress.exhausted && !finite(merit_);
  progress.singular = Mask<T>(false);
  if (any(progress.taken)) {
    T a[C::count][C::count], b[C::count];
    for (int i = 0; i < C::count; ++i) {
      b[i] = trial_force_[i];
      for (int j = 0; j < C::count; ++j) a[i][j] = trial_stiffness_[i][j];
    }
    solve_linear<C::count>(a, b);
    T sum(0.0), longest(0.0);
    for (int i = 0; i < C::count; ++i) sum = sum + b[i] - b[i];
    const Mask<T> stays = progress.converged && !finite(sum);
    for (int i = 0; i < C::count; ++i) {
      step_[C::at[i]] = select(progress.taken, select(stays, T(0.0), b[i]), step_[C::at[i]]);
      if (C::at[i] < 3) longest = max(longest, abs(step_[C::at[i]]));
    }
    progress.singular = open && !progress.exhausted && !progress.not_finite && !finite(sum);
    const T allowed = 0.5 * (point.ball.inner_radius + point.ball.outer_radius);
    const T whole = select(longest > allowed, allowed / longest, T(1.0));
    fraction_ = select(progress.taken, whole, 0.5 * fraction_);
    halvings_ = select(progress.taken, T(0.0), halvings_ + 1.0);
    steps = select(open, steps + 1.0, steps);
  } else {
    fraction_ = 0.5 * fraction_;
    halvings_ = halvings_ + 1.0;
  }
  fresh_ = T(0.0);
  advance<model, C>(circle);
  return progress;
}

}  // namespace raceway::bearing
