#pragma once

#include <algorithm>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "bearing/ring_newton.h"

namespace raceway::bearing {

/// Ring and ball positions. Tilts are multiplied by the radius R_i of the circle of the inner
/// groove centres, so all positions are lengths [m].
struct RingState {
  Vector5 ring = Vector5::Zero();
  std::vector<Plane> balls;
};

/// Working memory of the solver. The solver uses the same memory for each operating point. Use one
/// object for each thread.
struct RingWorkspace {
  RingNewton<double> newton;
  RingState state;
  std::vector<BallReport<double>> reports;
};

/// Solves the equilibrium of one inner ring under one load by Newton's method. This class is
/// internal to the solver. find_equilibrium() (equilibrium_search.h) chooses the starting states.
/// After the first operating point, the class allocates no memory.
class RingSystem {
 public:
  RingSystem(const Bearing& bearing, const OperatingPoint& point, const EquilibriumOptions& options,
             RingWorkspace& workspace);

  void set_point(const OperatingPoint& point);

  /// Iterates from `state` until the residual is within the tolerance. Returns true if the
  /// iteration has changed `state` to an equilibrium. If the function returns false, `state` is
  /// undefined.
  [[nodiscard]] bool newton(RingState& state);
  /// Writes the equilibrium of `state` to `result`, except status and iterations.
  void fill(const RingState& state, BearingEquilibrium& result) const;

  [[nodiscard]] const Bearing& bearing() const { return bearing_; }
  [[nodiscard]] const BearingGeometry& geometry() const { return bearing_.geometry(); }
  [[nodiscard]] const EquilibriumOptions& options() const { return options_; }
  [[nodiscard]] const BallConstantsOf<double>& constants() const { return point_.ball; }
  [[nodiscard]] Symmetry symmetry() const { return circle_.symmetry; }
  [[nodiscard]] bool at_rest() const { return model_ == BallModel::at_rest; }
  /// Applied forces, and applied moments divided by the radius R_i (see RingState) [N].
  [[nodiscard]] Vector5 load() const { return Eigen::Map<const Vector5>(point_.load); }
  [[nodiscard]] double load_scale() const { return point_.load_scale; }
  [[nodiscard]] double lever() const { return point_.lever; }
  [[nodiscard]] Plane free_groove_centre() const { return point_.free; }
  [[nodiscard]] int iterations() const { return iterations_; }
  /// Reason why newton() failed. The reason is `singular` or `not_finite` if every attempt failed
  /// because of a singular stiffness or a value that is not finite, otherwise `no_equilibrium`.
  [[nodiscard]] SolveStatus failure() const { return failure_; }
  /// Allows at most `steps` further Newton steps, in all following calls of newton() together. The
  /// limit EquilibriumOptions::max_iterations still applies.
  void allow(int steps) { end_ = std::min(options_.max_iterations, iterations_ + steps); }
  /// True if all allowed steps are used, so that newton() makes no further step.
  [[nodiscard]] bool exhausted() const { return iterations_ >= end_; }

  /// Number of balls whose positions are unknowns: one, Z/2 + 1, or all Z (see Symmetry).
  [[nodiscard]] std::size_t balls_used() const { return static_cast<std::size_t>(circle_.used()); }
  /// Number of balls with the same load as ball k, including ball k [1].
  [[nodiscard]] double weight(std::size_t k) const { return circle_.weight(static_cast<int>(k)); }
  /// Centre of the inner groove at the azimuth of ball k, for the ring position `ring` [m].
  [[nodiscard]] Plane groove_centre(const Vector5& ring, std::size_t k) const;
  /// Position of a ball without inner contact. The ball lies against the outer race and orbits at
  /// nearly half the shaft speed.
  [[nodiscard]] Plane thrown_ball() const;

  /// Assumption about the inner contact of each ball: InnerContact::kept or InnerContact::lost. If
  /// the list is empty, InnerContact::automatic applies to every ball.
  std::vector<InnerContact> contacts;
  int newton_limit = 40;     ///< largest number of steps in one call of newton()
  double newton_rise = 4.0;  ///< NewtonLimits::rise, largest rise of the merit in a full step [1]

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
