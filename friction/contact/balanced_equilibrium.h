#pragma once

#include <limits>
#include <span>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "friction/contact/ball_attitude.h"

namespace raceway::friction::contact {

/// Rotations of the balls of one bearing, for a solver that alternates between ball forces and ball
/// rotations.
class TurningBalls {
 public:
  TurningBalls(const bearing::Bearing& bearing, double speed, const OilState& oil,
               const ContactLaw& law)
      : attitudes_of_(bearing, speed, oil, law), bearing_(&bearing), speed_(speed) {}

  /// Computes the rotation of each ball in `balls` under the forces on this ball, starting from the
  /// result of the previous call. Returns false if the solver finds no rotation for a ball;
  /// `status()` then gives the reason. `ball_scale` is a typical load on a ball [N].
  [[nodiscard]] bool turn(std::span<const bearing::BallEquilibrium> balls, double ball_scale);
  /// True if the last call of turn() changed the ball forces by at most the solver tolerance, and
  /// if the computed cage speeds agree with the cage speeds that were used for the film thickness.
  /// At standstill, the changes of the ball forces are not checked.
  [[nodiscard]] bool settled() const;
  /// Largest change of a force on a ball in the last call of turn(), divided by the sum of the
  /// outer contact load of this ball and `ball_scale` [1].
  [[nodiscard]] double change() const { return change_; }
  [[nodiscard]] bearing::SolveStatus status() const { return status_; }
  [[nodiscard]] const std::vector<bearing::GivenRotation>& rotations() const { return rotations_; }
  [[nodiscard]] const std::vector<BallAttitude>& attitudes() const { return attitudes_; }

 private:
  void follow(const std::vector<bearing::GivenRotation>& found);

  BallAttitudes attitudes_of_;
  const bearing::Bearing* bearing_;
  double speed_;
  std::vector<BallAttitude> attitudes_;
  std::vector<bearing::GivenRotation> rotations_;
  double change_ = 0.0, films_ = 0.0;
  double share_ = 1.0, last_change_ = std::numeric_limits<double>::infinity();
  bearing::SolveStatus status_ = bearing::SolveStatus::not_run;
};

/// Equilibrium of a bearing in which contact traction, not race control, determines the rotation of
/// the balls. If the solver does not converge, only the members `report` and `equilibrium.report`
/// are valid.
struct BalancedEquilibrium {
  /// Equilibrium of the bearing, including the ball rotations. `equilibrium.report` contains the
  /// force residual and the total number of Newton steps.
  bearing::BearingEquilibrium equilibrium;
  std::vector<BallAttitude> attitudes;  ///< rotation of each ball in equilibrium.balls.distinct()
  /// Status of the complete solution. `iterations` is the number of passes over ball forces and
  /// ball rotations. `residual` is the largest change of a force on a ball in the last pass,
  /// divided by the sum of the outer contact load and a typical ball load [1].
  bearing::SolveReport report;
};

/// Finds the displacement of the inner ring at which the bearing balances the load, and the
/// rotation of each ball (BallAttitudes). The centrifugal force at the computed orbital speed and
/// the friction forces T_i, T_o at both contacts act on each ball.
///
/// The solver alternates between ball forces and ball rotations. The solver starts from outer race
/// control or, if `neighbour` is given, from the ball rotations in `neighbour`, which is the
/// solution for a similar operating point. With nearly unloaded balls at very high speed, the
/// solver may not converge; `report` then gives the reason. In tests, the solver failed in fewer
/// than 1 of 100 extreme cases.
///
/// Domain:   the same as for solve_bearing_equilibrium(). At standstill, the ball rotations do not
///           affect the forces. The function ignores `options.race_control` and
///           `options.rotations`, because it computes the ball rotations itself.
/// Accuracy: the forces on a ball are accurate to 1e-8 of the ball load. The physical accuracy
///           depends on the traction law at small slip. In a full film, where traction is small,
///           contact angles are accurate to 0.1 degrees. In mixed lubrication, the direction of the
///           rotation axis (pitch angle) also depends on the share of the load that the asperities
///           carry.
[[nodiscard]] BalancedEquilibrium solve_balanced_equilibrium(
    const bearing::Bearing& bearing, const bearing::OperatingPoint& point, const OilState& oil,
    const ContactLaw& law, const bearing::EquilibriumOptions& options = {},
    const bearing::BearingEquilibrium* neighbour = nullptr);

/// Finds the equilibrium of an arrangement of bearings in which traction determines the rotation of
/// the balls, as in solve_balanced_equilibrium(). `oils` contains one entry for each bearing, or
/// one entry for all bearings. Throws std::invalid_argument in the same cases as
/// solve_arrangement(), and if the number of entries of `oils` is wrong.
[[nodiscard]] bearing::ArrangementEquilibrium solve_balanced_arrangement(
    const bearing::Arrangement& arrangement, const bearing::ArrangementCondition& condition,
    std::span<const OilState> oils, const ContactLaw& law,
    const bearing::EquilibriumOptions& options = {},
    const bearing::ArrangementEquilibrium* neighbour = nullptr);

/// Returns the friction of a bearing in which traction determines the rotation of the balls. For
/// race control, use bearing_friction(). The function computes the rotations for this oil and
/// contact law, under the ball loads of `equilibrium`. The moments are NaN if the equilibrium did
/// not converge or if no rotation is found for a ball.
template <typename Look>
[[nodiscard]] BearingFriction balanced_friction(const bearing::Bearing& bearing,
                                                const bearing::BearingEquilibrium& equilibrium,
                                                double speed, const OilState& oil,
                                                const ContactLaw& law, Look&& look) {
  if (!equilibrium.report.converged()) return BearingFriction::none();
  const BallAttitudes races(bearing, speed, oil, law);
  bool found = true;
  const auto contacts = [&](std::size_t, const bearing::BallEquilibrium& ball) {
    const BallAttitude a = races.solve(ball);
    found = found && a.report.converged();
    return races.contacts(a, ball);
  };
  const BearingFriction sum = sum_over_contacts(equilibrium, races.turning(), contacts, look);
  return found ? sum : BearingFriction::none();
}

[[nodiscard]] inline BearingFriction balanced_friction(
    const bearing::Bearing& bearing, const bearing::BearingEquilibrium& equilibrium, double speed,
    const OilState& oil, const ContactLaw& law) {
  return balanced_friction(bearing, equilibrium, speed, oil, law, no_look);
}

}  // namespace raceway::friction::contact
