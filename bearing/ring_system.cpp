#include "bearing/ring_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raceway::bearing {

RingSystem::RingSystem(const Bearing& bearing, const OperatingPoint& point,
                       const EquilibriumOptions& options, RingWorkspace& workspace)
    : bearing_(bearing),
      options_(options),
      workspace_(workspace),
      point_(unloaded_point(bearing, options)),
      end_(options.max_iterations) {
  set_point(point);
}

void RingSystem::set_point(const OperatingPoint& p) {
  set_operating_point(point_, bearing_, p, options_);
  circle_ = ball_circle(bearing_, p, options_);
  model_ = ball_model(point_, options_);
}

bool RingSystem::newton(RingState& state) {
  RingNewton<double>& newton = workspace_.newton;
  newton.point = point_;
  newton.resize(balls_used());
  std::copy(state.ring.begin(), state.ring.end(), newton.ring);
  std::copy(state.ring.begin(), state.ring.end(), newton.trial_ring);
  newton.trial_balls.swap(state.balls);
  newton.begin(0);
  const NewtonLimits limits{.tolerance = options_.tolerance,
                            .steps = std::min(newton_limit, std::max(0, end_ - iterations_)),
                            .rise = newton_rise};
  const InnerContact* const held = contacts.empty() ? nullptr : contacts.data();
  const NewtonProgress<double> end = with_model(model_, [&](auto model) {
    return with_coordinates(circle_.symmetry, options_.tilt == Tilt::free, [&](auto coordinates) {
      for (;;) {
        const auto progress =
            newton.pass<decltype(model)::value, decltype(coordinates)>(circle_, limits, held);
        if (progress.converged || progress.exhausted || progress.not_finite || progress.singular)
          return progress;
      }
    });
  });
  iterations_ += static_cast<int>(newton.steps) - (end.converged ? 0 : 1);
  const double* const ring = end.converged ? newton.trial_ring : newton.ring;
  std::copy(ring, ring + 5, state.ring.begin());
  (end.converged ? newton.trial_balls : newton.balls).swap(state.balls);
  // At rest balls are no unknowns; a path in speed starts from where they lie.
  for (std::size_t k = 0; at_rest() && k < state.balls.size(); ++k)
    state.balls[k] =
        static_ball(point_.ball, point_.springs, groove_centre(state.ring, k)).ball_centre;
  if (end.converged) return true;
  return fail(end.not_finite ? SolveStatus::not_finite
              : end.singular ? SolveStatus::singular
                             : SolveStatus::no_equilibrium);
}

bool RingSystem::fail(SolveStatus why) {
  if (!attempted_ || why == SolveStatus::no_equilibrium) failure_ = why;
  attempted_ = true;
  return false;
}

void RingSystem::fill(const RingState& state, BearingEquilibrium& result) const {
  std::vector<BallReport<double>>& balls = workspace_.reports;
  balls.resize(balls_used());
  RingReport<double> ring;
  with_model(model_, [&](auto model) {
    report_ring<decltype(model)::value>(point_, circle_, options_.tilt == Tilt::free,
                                        state.ring.data(), state.balls.data(), balls.data(), ring);
  });
  fill_equilibrium(point_.lever, circle_, state.ring.data(), ring, balls.data(), 0, result);
}

Plane RingSystem::groove_centre(const Vector5& ring, std::size_t k) const {
  return bearing::groove_centre<AllCoordinates>(point_, circle_, ring.data(), static_cast<int>(k));
}

Plane RingSystem::thrown_ball() const {
  const double force = 0.2 * constants().full_centrifugal;
  return {0.0, constants().outer_radius + std::pow(force / constants().outer_stiffness, 2.0 / 3.0)};
}

}  // namespace raceway::bearing
