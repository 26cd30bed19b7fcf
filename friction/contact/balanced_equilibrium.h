#pragma once

#include <limits>
#include <span>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "friction/contact/ball_attitude.h"

namespace raceway::friction::contact {

/// The balls of one bearing on the way to their balance: forces and rotations in turn.
class TurningBalls {
 public:
  TurningBalls(const bearing::Bearing& bearing, double speed, const OilState& oil,
               const ContactLaw& law)
      : attitudes_of_(bearing, speed, oil, law), bearing_(&bearing), speed_(speed) {}

  /// Turns the distinct balls under these forces, from the last attitudes. False where one has no
  /// attitude; `status()` says why. `ball_scale`: load on a ball [N].
  [[nodiscard]] bool turn(std::span<const bearing::BallEquilibrium> balls, double ball_scale);
  /// The rotations found are those that the forces were found with.
  [[nodiscard]] bool settled() const;
  /// Change of the forces on a ball in the last turn(), over its load plus `ball_scale` [1].
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
  /// Share of the step to the rotations found; less where forces and rotations oscillate.
  double share_ = 1.0, last_change_ = std::numeric_limits<double>::infinity();
  bearing::SolveStatus status_ = bearing::SolveStatus::not_run;
};

/// A bearing whose balls turn as traction at their contacts turns them, no race holding them.
/// Only `report` is set unless the solve converged.
struct BalancedEquilibrium {
  /// With `rotations`. Its report: Newton steps of all passes; the residual of the forces.
  bearing::BearingEquilibrium equilibrium;
  std::vector<BallAttitude> attitudes;  ///< of equilibrium.balls.distinct()
  /// Status of the whole; iterations: passes over forces and attitudes. Residual: what the last
  /// attitude would change of the forces on its ball, of the load that presses it [1].
  bearing::SolveReport report;
};

/// Finds the displacement of the inner ring at which the balls carry the load, and the rotation of
/// each ball by BallAttitudes, together: the orbital speed and the frictions T_i, T_o of the
/// attitudes are part of the forces on the balls.
///
/// Forces for given rotations and rotations for given forces in turn, from outer control or the
/// rotations of a neighbour. The pitch angles, creeps and frictions that go from one to the other
/// hardly depend on what they change, and where they do the steps become shorter; balls that are
/// nearly unloaded at very high speed may not settle (fewer than 1 in 100 wild ones, tested), and
/// the report says so.
///
/// Domain:   as solve_bearing_equilibrium(); at standstill the attitudes move nothing.
///           `options.race_control` and `rotations` are not looked at.
/// Accuracy: 1e-8 on the forces of each ball. Physically as good as traction at small slip: angles
///           0.1 degrees in a full film, where traction hardly holds anything; between a film and
///           boundary friction the pitch angle follows the asperities' share of load.
[[nodiscard]] BalancedEquilibrium solve_balanced_equilibrium(
    const bearing::Bearing& bearing, const bearing::OperatingPoint& point, const OilState& oil,
    const ContactLaw& law, const bearing::EquilibriumOptions& options = {},
    const bearing::BearingEquilibrium* neighbour = nullptr);

/// Solves an arrangement; `oils`: one for each bearing, or one for all. The report covers the whole
/// arrangement; iterations are Newton's. Throws std::invalid_argument as solve_arrangement(), and
/// for another number of oils.
[[nodiscard]] bearing::ArrangementEquilibrium solve_balanced_arrangement(
    const bearing::Arrangement& arrangement, const bearing::ArrangementCondition& condition,
    std::span<const OilState> oils, const ContactLaw& law,
    const bearing::EquilibriumOptions& options = {},
    const bearing::ArrangementEquilibrium* neighbour = nullptr);

/// Friction of a bearing in balance whose balls turn by traction, as bearing_friction() by race
/// control. The attitudes follow from this oil and law under the forces of the balance, also where
/// a film has warmed up since. NaN where a ball has none.
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
