#pragma once

#include <array>
#include <vector>

#include "bearing/ball_equilibrium.h"
#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Which balls and which ring coordinates a load needs.
enum class Symmetry {
  thrust,  ///< all balls alike: one ball, x
  mirror,  ///< load in the x-y plane: half the balls, x, y (and θz)
  none     ///< all balls, x, y, z (and θy, θz)
};

/// Ring and ball positions. Tilts are multiplied by R_i, moments divided by it: all lengths, all
/// forces, so that one scale fits all components.
struct RingState {
  Vector5 ring = Vector5::Zero();
  std::vector<Plane> balls;
};

/// Ring forces, their derivatives with the balls eliminated, and the step each ball would take.
struct Assembly {
  Vector5 missing;        ///< applied load minus what the balls carry [N]
  Vector5 missing_ahead;  ///< the same once the balls have made their own Newton step [N]
  Matrix5 stiffness;      ///< with the balls eliminated [N/m]
  double residual;        ///< largest imbalance of ring and balls, scaled [1]
  double merit;           ///< sum of squares of the same
  struct Ball {
    double own[2];     ///< step of the ball for a ring at rest [m]
    double follow[4];  ///< step of the ball per step of its groove centre [1]
    BallForces forces;
  };
  std::vector<Ball> balls;
};

/// Memory of a solve, kept between solves so that they need not allocate. One per thread.
struct RingWorkspace {
  Assembly now, trial;
  RingState state, trial_state;
};

/// What one ball does to the ring, in its own plane, the ball's position eliminated.
struct BallShare {
  double force[3];    ///< f_axial, f_radial, f_m [N]
  double gain[3];     ///< change of these by the ball's own Newton step [N]
  double tangent[6];  ///< their derivatives by (A_axial, A_radial), row-major 3x2 [N/m]
  double imbalance;   ///< of the ball, squared and scaled [1]
};

/// The balance of one inner ring under one load, and Newton's method on it. Internal to the solver:
/// which states to start from is equilibrium_search.h's business. Scalars, no allocation once the
/// first point has been assembled.
class RingSystem {
 public:
  RingSystem(const Bearing& bearing, const OperatingPoint& point, const EquilibriumOptions& options,
             RingWorkspace& workspace);

  void set_point(const OperatingPoint& point);

  /// Iterates from `state` to balance within the tolerance. False leaves `state` anywhere.
  [[nodiscard]] bool newton(RingState& state);
  /// Forces and derivatives at `state`; newton() leaves them at its solution.
  void assemble(const RingState& state, Assembly& assembly) const;
  [[nodiscard]] const Assembly& solution() const { return workspace_.now; }
  void assemble_solution(const RingState& state) { assemble(state, workspace_.now); }

  [[nodiscard]] const Bearing& bearing() const { return bearing_; }
  [[nodiscard]] const BearingGeometry& geometry() const { return bearing_.geometry(); }
  [[nodiscard]] const EquilibriumOptions& options() const { return options_; }
  [[nodiscard]] const BallConstants& constants() const { return constants_; }
  [[nodiscard]] Symmetry symmetry() const { return symmetry_; }
  [[nodiscard]] bool at_rest() const { return at_rest_; }
  [[nodiscard]] const Vector5& load() const { return load_; }
  [[nodiscard]] double load_scale() const { return load_scale_; }
  [[nodiscard]] double lever() const { return lever_; }
  [[nodiscard]] double moment_arm_ratio() const { return moment_arm_ratio_; }
  [[nodiscard]] Plane free_groove_centre() const { return free_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  /// Why newton() failed: no_equilibrium unless every attempt was singular or not finite.
  [[nodiscard]] SolveStatus failure() const { return failure_; }
  [[nodiscard]] bool exhausted() const { return iterations_ >= options_.max_iterations; }

  /// Balls that are unknowns: one, half of them, or all.
  [[nodiscard]] std::size_t balls_used() const { return static_cast<std::size_t>(balls_used_); }
  /// How many balls of the bearing ball k stands for [1].
  [[nodiscard]] double weight(std::size_t k) const;
  /// Inner groove centre of ball k [m].
  [[nodiscard]] Plane groove_centre(const Vector5& ring, std::size_t k) const;
  /// A ball without inner contact: against the outer race, orbiting at nearly half the shaft speed.
  [[nodiscard]] Plane thrown_ball() const;

  std::vector<InnerContact> contacts;  ///< held contacts; empty while physics decides
  int newton_limit = 40;               ///< steps of one newton()
  double couple = 1.0;  ///< share of the gyroscopic couple that is applied [1]; see set_point()

 private:
  bool fail(SolveStatus why);
  void advance(const RingState& from, const Vector5& step, double fraction, RingState& to) const;
  [[nodiscard]] Plane groove_step(const Vector5& step, std::size_t k) const;
  template <int N>
  bool solve_active(const std::array<int, N>& active, Vector5& step) const;
  bool ring_step(Vector5& step) const;
  [[nodiscard]] BallShare static_share(Plane centre, Assembly::Ball& ball) const;
  template <RaceControl control>
  [[nodiscard]] BallShare moving_share(Plane centre, Plane ball_centre, InnerContact contact,
                                       Assembly::Ball& ball) const;
  void add_ball(std::size_t k, const BallShare& share, Vector5& carried, Vector5& ahead,
                Matrix5& stiffness) const;

  const Bearing& bearing_;
  const EquilibriumOptions& options_;
  RingWorkspace& workspace_;
  double lever_, moment_arm_ratio_;
  Plane free_;  ///< inner groove centre without displacement
  Symmetry symmetry_ = Symmetry::none;
  BallConstants constants_{};
  bool at_rest_ = false;
  Vector5 load_;  ///< moments divided by the lever [N]
  double load_scale_ = 0.0, ball_scale_ = 0.0;
  int balls_used_ = 0;
  int iterations_ = 0;
  SolveStatus failure_ = SolveStatus::no_equilibrium;
  bool attempted_ = false;
};

}  // namespace raceway::bearing
