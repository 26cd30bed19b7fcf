#pragma once

#include <limits>
#include <span>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "friction/contact/ball_attitude.h"

namespace raceway::friction::contact {

/// Balls of one bearing during the alternating solution for forces and rotations.
class TurningBalls {
 public:
  TurningBalls(const bearing::Bearing& bearing, double speed, const OilState& oil,
               const ContactLaw& law)
      : attitudes_of_(bearing, speed, oil, law), bearing_(&bearing), speed_(speed) {}

  /// Computes the rotation of the distinct balls under these forces, starting from the last
  /// attitudes. Returns false if a ball has no attitude; `status()` gives the reason. `ball_scale`:
  /// load on a ball [N].
  [[nodiscard]] bool turn(std::span<const bearing::BallEquilibrium> balls, double ball_scale);
  /// True if the rotations equal those used to find the forces.
  [[nodiscard]] bool settled() const;
  /// Change of the forces on a ball in the last turn(), relative to its load plus `ball_scale` [1].
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
  /// Share of the step towards the rotations found. Smaller if forces and rotations oscillate.
  double share_ = 1.0, last_change_ = std::numeric_limits<double>::infinity();
  bearing::SolveStatus status_ = bearing::SolveStatus::not_run;
};

/// Equilibrium of a bearing whose balls rotate as contact traction requires, without race control.
/// Only `report` is set unless the solve converged.
struct BalancedEquilibrium {
  /// Equilibrium, with `rotations`. Its report counts the Newton steps of all passes and gives the
  /// force residual.
  bearing::BearingEquilibrium equilibrium;
  std::vector<BallAttitude> attitudes;  ///< attitudes of equilibrium.balls.distinct()
  /// Status of the complete solution. Iterations are passes over forces and attitudes. The residual
  /// is the change of the forces on a ball in the last pass, relative to its load [1].
  bearing::SolveReport report;
};

/// Finds the displacement of the inner ring in equilibrium with the load, together with the
/// rotation of each ball (BallAttitudes). The orbital speed and the friction forces T_i, T_o of the
/// attitudes act on the balls.
///
/// The solver alternates between forces for given rotations and rotations for given forces. It
/// starts from outer control or the rotations of a neighbour. The coupling is weak; where it is
/// not, the solver shortens its steps. Nearly unloaded balls at very high speed may not converge
/// (fewer than 1 in 100 extreme cases, tested); the report says so.
///
/// Domain:   as solve_bearing_equilibrium(); at standstill the attitudes change no force.
///           `options.race_control` and `rotations` are ignored.
/// Accuracy: 1e-8 on the forces of each ball. The physics is as accurate as traction at small slip:
///           angles to 0.1 degrees in a full film, where traction is small. In mixed lubrication
///           the pitch angle follows the asperities' share of load.
[[nodiscard]] BalancedEquilibrium solve_balanced_equilibrium(
    const bearing::Bearing& bearing, const bearing::OperatingPoint& point, const OilState& oil,
    const ContactLaw& law, const bearing::EquilibriumOptions& options = {},
    const bearing::BearingEquilibrium* neighbour = nullptr);

/// Solves an arrangement; `oils`: one for each bearing, or one for all. The report covers the whole
/// arrangement and counts Newton iterations. Throws std::invalid_argument as solve_arrangement(),
/// and for another number of oils.
[[nodiscard]] bearing::ArrangementEquilibrium solve_balanced_arrangement(
    const bearing::Arrangement& arrangement, const bearing::ArrangementCondition& condition,
    std::span<const OilState> oils, const ContactLaw& law,
    const bearing::EquilibriumOptions& options = {},
    const bearing::ArrangementEquilibrium* neighbour = nullptr);

/// Friction of a bearing in equilibrium whose balls rotate by traction; bearing_friction() is its
/// counterpart for race control. The attitudes follow from this oil and law under the equilibrium
/// forces, even if the film has warmed up since. NaN if a ball has no attitude.
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
