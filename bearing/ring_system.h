#pragma once

#include <algorithm>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "bearing/ring_newton.h"

namespace raceway::bearing {

/// Ring and ball positions. Tilts are multiplied and moments are divided by the radius R_i of the
/// circle of the inner groove centres, so all positions are lengths and all loads are forces. The
/// imbalances of all components can then be divided by one load (load_scale).
struct RingState {
  Vector5 ring = Vector5::Zero();
  std::vector<Plane> balls;
};

/// Working memory of a solve. Later solves use the same memory again. Use one object for each
/// thread.
struct RingWorkspace {
  RingNewton<double> newton;
  RingState state;
  std::vector<BallReport<double>> reports;
};

/// Equilibrium of one inner ring under one load, solved by Newton's method. This class is internal
/// to the solver; equilibrium_search.h chooses the starting states. No memory is allocated after
/// the first point.
class RingSystem {
 public:
  RingSystem(const Bearing& bearing, const OperatingPoint& point, const EquilibriumOptions& options,
             RingWorkspace& workspace);

  void set_point(const OperatingPoint& point);

  /// Iterates from `state` to equilibrium within the tolerance. If the function returns false,
  /// `state` is undefined.
  [[nodiscard]] bool newton(RingState& state);
  /// Writes the equilibrium of `state` to `result`, except status and iterations.
  void fill(const RingState& state, BearingEquilibrium& result) const;

  [[nodiscard]] const Bearing& bearing() const { return bearing_; }
  [[nodiscard]] const BearingGeometry& geometry() const { return bearing_.geometry(); }
  [[nodiscard]] const EquilibriumOptions& options() const { return options_; }
  [[nodiscard]] const BallConstantsOf<double>& constants() const { return point_.ball; }
  [[nodiscard]] Symmetry symmetry() const { return circle_.symmetry; }
  [[nodiscard]] bool at_rest() const { return model_ == BallModel::at_rest; }
  /// Applied load; moments are divided by the lever R_i [N].
  [[nodiscard]] Vector5 load() const { return Eigen::Map<const Vector5>(point_.load); }
  [[nodiscard]] double load_scale() const { return point_.load_scale; }
  [[nodiscard]] double lever() const { return point_.lever; }
  [[nodiscard]] Plane free_groove_centre() const { return point_.free; }
  [[nodiscard]] int iterations() const { return iterations_; }
  /// Reason why newton() failed: no_equilibrium unless every attempt was singular or not finite.
  [[nodiscard]] SolveStatus failure() const { return failure_; }
  /// Limits the following search to this number of steps, in addition to the limit of the options.
  void allow(int steps) { end_ = std::min(options_.max_iterations, iterations_ + steps); }
  /// True if the allowed steps are used up; newton() then makes no step.
  [[nodiscard]] bool exhausted() const { return iterations_ >= end_; }

  /// Number of balls whose positions are unknowns: one, half of the balls, or all balls.
  [[nodiscard]] std::size_t balls_used() const { return static_cast<std::size_t>(circle_.used()); }
  /// Number of balls that ball k represents [1].
  [[nodiscard]] double weight(std::size_t k) const { return circle_.weight(static_cast<int>(k)); }
  /// Inner groove centre of ball k [m].
  [[nodiscard]] Plane groove_centre(const Vector5& ring, std::size_t k) const;
  /// Position of a ball without inner contact. The ball lies against the outer race and orbits at
  /// nearly half the shaft speed.
  [[nodiscard]] Plane thrown_ball() const;

  /// Inner contact of each ball, `kept` or `lost`; empty: `automatic` for every ball.
  std::vector<InnerContact> contacts;
  int newton_limit = 40;     ///< largest number of steps in one call of newton()
  double newton_rise = 4.0;  ///< NewtonLimits::rise for the next call of newton() [1]

 private:
  bool fail(SolveStatus why);

  const Bearing& bearing_;
  const EquilibriumOptions& options_;
  RingWorkspace& workspace_;
  RingPoint<double> point_;
  BallCircle circle_{};
  BallModel model_ = BallModel::at_rest;
  int iterations_ = 0, end_;
  SolveStatus failure_ = SolveStatus::no_equilibrium;
  bool attempted_ = false;
};

}  // namespace raceway::bearing
