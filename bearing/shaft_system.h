#pragma once

#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/ball_equilibrium.h"

namespace raceway::bearing {

/// Positions that are unknowns: the shaft, the rear set, and one ball of every bearing.
struct ShaftState {
  /// Shaft position y = d x of Arrangement, positive where the front set pushes; 0 as mounted [m].
  double shaft = 0.0;
  double rear = 0.0;  ///< axial compression δ_r of the rear set [m]
  std::vector<Plane> balls;
};

/// Axial force of one bearing, the derivative of this force with the ball positions eliminated, and
/// the Newton step of a ball. All balls of the bearing are equal.
struct BearingShare {
  double force = 0.0;      ///< Z f_axial, axial force of all balls on the ring [N]
  double gain = 0.0;       ///< change of the force by the ball's own Newton step [N]
  double stiffness = 0.0;  ///< derivative of the force with respect to displacement [N/m]
  double imbalance = 0.0;  ///< square of the ball's imbalance, scaled by the load per ball + Qo [1]
  double own[2] = {};      ///< step of the ball while the ring does not move [m]
  double follow[2] = {};   ///< step of the ball per axial step of its groove centre [1]
  BallForcesOf<double> ball{};
};

struct ShaftAssembly {
  std::vector<BearingShare> bearings;
  BearingShare front, rear;  ///< sums over each side
  double shaft_imbalance;    ///< F_f - F_r + d P: forces of front and rear set, external load [N]
  /// Imbalance in the support of the rear set, with the symbols of Arrangement and its Seat:
  ///   softness (F_r - F_0) - hardness (d (x - e) - (δ_r - δ_r0))
  double seat_imbalance;
  double residual;  ///< largest scaled imbalance [1]
  double merit;     ///< sum of squares of the scaled imbalances
};

/// Equilibrium of a shaft on its bearing sets, solved by Newton's method. This class is internal to
/// the solver.
class ShaftSystem {
 public:
  ShaftSystem(const Arrangement& arrangement, const EquilibriumOptions& options);

  /// Sets the condition, with `speed_share` of the squared speed, and `load_share` of the load, the
  /// elongation and the shifts.
  void set_condition(const ArrangementCondition& condition, double speed_share = 1.0,
                     double load_share = 1.0);
  /// Iterates from `state` to equilibrium within the tolerance. If the function returns false,
  /// `state` is undefined.
  [[nodiscard]] bool newton(ShaftState& state);
  [[nodiscard]] const ShaftAssembly& solution() const { return now_; }

  [[nodiscard]] bool at_rest() const { return at_rest_; }
  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] const BallConstants& constants(std::size_t i) const {
    return members_[i].constants;
  }
  /// Given rotation of the balls of bearing i; null at rest or without a given rotation.
  [[nodiscard]] const GivenRotation* rotation(std::size_t i) const {
    return at_rest_ || options_.rotations.empty() ? nullptr : &options_.rotations[i];
  }
  /// External axial load d P, positive in the direction in which the front set pushes the shaft
  /// [N].
  [[nodiscard]] double load() const { return load_; }
  [[nodiscard]] double displacement(const ShaftState& state, std::size_t i) const;
  [[nodiscard]] Plane groove_centre(const ShaftState& state, std::size_t i) const;
  /// Position of a ball that only the centrifugal force presses against the outer race.
  [[nodiscard]] Plane thrown_ball(std::size_t i) const;
  /// True if bearing i > 0 is on the same side as bearing i - 1 and has the same condition and
  /// equilibrium.
  [[nodiscard]] bool alike(const ShaftState& state, std::size_t i) const {
    return members_[i].like_last && (at_rest_ || state.balls[i] == state.balls[i - 1]);
  }
  /// Tangent stiffness of the shaft: external load per displacement [N/m].
  [[nodiscard]] double stiffness() const;
  /// Force of the rear set or, in tandem, of the spring [N].
  [[nodiscard]] double rear_force(const ShaftState& state) const;
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] bool exhausted() const { return iterations_ >= options_.max_iterations; }
  /// Reason why newton() failed: no_equilibrium unless every attempt was singular or not finite.
  [[nodiscard]] SolveStatus failure() const { return failure_; }
  /// Clears iterations and failures.
  void restart();

 private:
  /// A bearing in its set, with its shift.
  struct Member {
    BallConstants constants;
    Plane free;      ///< inner groove centre without displacement [m]
    double offset;   ///< additional compression relative to its set [m]
    double count;    ///< Z, number of balls
    bool like_last;  ///< true: same bearing, offset, shift, rotation and side as bearing i - 1
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
