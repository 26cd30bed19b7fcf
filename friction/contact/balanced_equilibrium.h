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
  /// attitudes. Returns false if a ball has no attitude; `status()` gives the reason. `ball_scale`
  /// is a typical load on a ball [N].
  [[nodiscard]] bool turn(std::span<const bearing::BallEquilibrium> balls, double ball_scale);
  /// True if the forces and the film speeds changed in the last turn() by at most their tolerances.
  [[nodiscard]] bool settled() const;
  /// Largest change of the forces on a ball in the last turn(), relative to its load plus
  /// `ball_scale` [1].
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
  /// Share of the step towards the new rotations. The share is reduced if forces and rotations
  /// oscillate.
  double share_ = 1.0, last_change_ = std::numeric_limits<double>::infinity();
  bearing::SolveStatus status_ = bearing::SolveStatus::not_run;
};

/// Equilibrium of a bearing whose balls rotate in equilibrium with contact traction, without race
/// control. Only `report` is set unless the solve converged.
struct BalancedEquilibrium {
  /// Equilibrium, with `rotations`. The report of the equilibrium has the number of Newton steps of
  /// all passes and the force residual.
  bearing::BearingEquilibrium equilibrium;
  std::vector<BallAttitude> attitudes;  ///< attitudes of equilibrium.balls.distinct()
  /// Status of the complete solution. Iterations are passes over forces and attitudes. The residual
  /// is the largest change of the forces on a ball in the last pass, relative to its load [1].
  bearing::SolveReport report;
};

/// Finds the displacement of the inner ring in equilibrium with the load, together with the
/// rotation of each ball (BallAttitudes). The orbital speed and the friction forces T_i, T_o of the
/// attitudes act on the balls.
///
/// The solver alternates between forces for given rotations and rotations for given forces. The
/// solver starts from outer control or the rotations of a neighbour. The coupling of forces and
/// rotations is usually weak; if the coupling is strong, the solver shortens its steps. With nearly
/// unloaded balls at very high speed the solver may not converge (fewer than 1 in 100 extreme
/// cases, tested). The report contains this status.
///
/// Domain:   as for solve_bearing_equilibrium(). At standstill the attitudes do not affect the
///           forces. `options.race_control` and `options.rotations` are ignored.
/// Accuracy: the forces of each ball to 1e-8. The physical accuracy is limited by traction at small
///           slip: contact angles are accurate to 0.1 degrees in a full film, where traction is
///           small. In mixed lubrication the pitch angle depends on the share of the load that
///           asperities carry.
[[nodiscard]] BalancedEquilibrium solve_balanced_equilibrium(
    const bearing::Bearing& bearing, const bearing::OperatingPoint& point, const OilState& oil,
    const ContactLaw& law, const bearing::EquilibriumOptions& options = {},
    const bearing::BearingEquilibrium* neighbour = nullptr);

/// Solves an arrangement. `oils` has one entry for each bearing, or one for all. The report is for
/// the whole arrangement, with the number of Newton iterations. Throws std::invalid_argument like
/// solve_arrangement(), and if the number of oils is wrong.
[[nodiscard]] bearing::ArrangementEquilibrium solve_balanced_arrangement(
    const bearing::Arrangement& arrangement, const bearing::ArrangementCondition& condition,
    std::span<const OilState> oils, const ContactLaw& law,
    const bearing::EquilibriumOptions& options = {},
    const bearing::ArrangementEquilibrium* neighbour = nullptr);

/// Friction of a bearing in equilibrium, for balls whose rotation follows from traction. Use
/// bearing_friction() for race control. The attitudes are computed with this oil and law under the
/// equilibrium forces, even if the oil had another temperature in the equilibrium. NaN without a
/// converged equilibrium, or if a ball has no attitude.
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
