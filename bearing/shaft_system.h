#pragma once

#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/ball_equilibrium.h"

namespace raceway::bearing {

/// Unknowns of the solver: positions of the shaft, of the rear set, and of one ball of every
/// bearing.
struct ShaftState {
  /// Shaft position y = d x [m], with d and x as in Arrangement: positive in the direction in which
  /// the front set pushes the shaft, and 0 in the mounted state.
  double shaft = 0.0;
  double rear = 0.0;  ///< axial compression δ_r of the rear set [m]
  std::vector<Plane> balls;
};

/// Axial force of one bearing, the derivative of this force, and the Newton step of a ball. All
/// balls of the bearing carry equal loads. The ball positions are eliminated from the equations.
struct BearingShare {
  double force = 0.0;  ///< Z f_axial, axial force of all balls on the ring [N]
  double gain = 0.0;   ///< change of `force` if all balls move by `own` [N]
  /// Derivative of `force` by the axial position of the inner groove [N/m].
  double stiffness = 0.0;
  /// Square of the scaled imbalance of a ball [1]. The imbalance is divided by the sum of F/Z and
  /// the load Qo of the ball at the outer race. F is the larger of preload and external load.
  double imbalance = 0.0;
  double own[2] = {};     ///< Newton step of the ball for a fixed ring [m]
  double follow[2] = {};  ///< additional ball step per axial step of the inner groove [1]
  BallForcesOf<double> ball{};
};

/// Forces and imbalances of the shaft and its bearings in one state. The imbalances of the shaft
/// and of the support are scaled by the largest axial force.
struct ShaftAssembly {
  std::vector<BearingShare> bearings;
  BearingShare front, rear;  ///< sums over the bearings of each set
  /// F_f - F_r + d P [N], with the forces F_f and F_r of front and rear set, the external load P,
  /// and d of Arrangement::direction().
  double shaft_imbalance;
  /// Imbalance in the support of the rear set, with the symbols of Arrangement and
  /// Arrangement::Seat:
  ///   softness (F_r - F_0) - hardness (d (x - e) - (δ_r - δ_r0))
  double seat_imbalance;
  double residual;  ///< largest scaled imbalance of shaft, support and balls [1]
  double merit;     ///< sum of the squares of all scaled imbalances [1]
};

/// Equilibrium of a shaft on its bearing sets, solved by Newton's method. This class is internal to
/// the solver.
class ShaftSystem {
 public:
  ShaftSystem(const Arrangement& arrangement, const EquilibriumOptions& options);

  /// Sets the operating condition. The function multiplies the square of the speed by
  /// `speed_share`, and load, elongation and shifts by `load_share`.
  void set_condition(const ArrangementCondition& condition, double speed_share = 1.0,
                     double load_share = 1.0);
  /// Iterates from `state` until ShaftAssembly::residual is within EquilibriumOptions::tolerance,
  /// or within ten times this tolerance if the iteration no longer improves the residual. If the
  /// function returns false, `state` is undefined.
  [[nodiscard]] bool newton(ShaftState& state);
  [[nodiscard]] const ShaftAssembly& solution() const { return now_; }

  [[nodiscard]] bool at_rest() const { return at_rest_; }
  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] const BallConstants& constants(std::size_t i) const {
    return members_[i].constants;
  }
  /// Returns the given rotation of the balls of bearing i; null at rest, and if race control
  /// determines the rotation.
  [[nodiscard]] const GivenRotation* rotation(std::size_t i) const {
    return at_rest_ || options_.rotations.empty() ? nullptr : &options_.rotations[i];
  }
  /// Returns the external axial load d P [N], positive in the direction in which the front set
  /// pushes the shaft.
  [[nodiscard]] double load() const { return load_; }
  [[nodiscard]] double displacement(const ShaftState& state, std::size_t i) const;
  [[nodiscard]] Plane groove_centre(const ShaftState& state, std::size_t i) const;
  /// Returns the position of a ball without inner contact, which the centrifugal force presses
  /// against the outer race.
  [[nodiscard]] Plane thrown_ball(std::size_t i) const;
  /// Returns true if bearings i and i - 1 belong to the same set and have equal conditions and
  /// equilibria (i > 0).
  [[nodiscard]] bool alike(const ShaftState& state, std::size_t i) const {
    return members_[i].like_last && (at_rest_ || state.balls[i] == state.balls[i - 1]);
  }
  /// Returns the tangent stiffness of the shaft: external load per displacement [N/m].
  [[nodiscard]] double stiffness() const;
  /// Returns the axial force of the rear set [N]; in tandem, the force of the spring.
  [[nodiscard]] double rear_force(const ShaftState& state) const;
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] bool exhausted() const { return iterations_ >= options_.max_iterations; }
  /// Returns the reason why newton() failed: the result is `singular` or `not_finite` if every
  /// attempt failed because of a singular stiffness or a value that is not finite, otherwise
  /// `no_equilibrium`.
  [[nodiscard]] SolveStatus failure() const { return failure_; }
  /// Sets the number of iterations to 0 and clears failure().
  void restart();

 private:
  /// A bearing with its position in the set and its shift.
  struct Member {
    BallConstants constants;
    Plane free;      ///< inner groove centre without displacement [m]
    double offset;   ///< compression of the bearing in addition to the compression of its set [m]
    double count;    ///< Z, number of balls
    bool like_last;  ///< true: bearing i - 1 is in the same set and has the same data
  };
  struct Step {
    double shaft, rear;
  };
  void assemble(const ShaftState& state, ShaftAssembly& a) const;
  [[nodiscard]] BearingShare share(const ShaftState& state, std::size_t i) const;
  [[nodiscard]] bool step(Step& s) const;
  void advance(const ShaftState& from, const Step& step, double fraction, ShaftState& to) const;
  bool fail(SolveStatus why);

  const Arrangement& arrangement_;
  const EquilibriumOptions& options_;
  std::vector<Member> members_;
  Arrangement::Seat seat_;
  double load_ = 0.0, elongation_ = 0.0, force_scale_ = 0.0, reference_stiffness_ = 0.0;
  double longest_step_ = 0.0;
  bool at_rest_ = true;
  ShaftAssembly now_, trial_;
  ShaftState trial_state_;
  int iterations_ = 0;
  SolveStatus failure_ = SolveStatus::no_equilibrium;
  bool attempted_ = false;
};

}  // namespace raceway::bearing
