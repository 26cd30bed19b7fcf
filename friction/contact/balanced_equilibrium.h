#pragma once

#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "friction/contact/ball_attitude.h"

namespace raceway::friction::contact {

/// A bearing whose balls turn as traction at their contacts turns them, no race holding them.
/// Only `report` is set unless the solve converged.
struct BalancedEquilibrium {
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
/// Forces for given rotations and rotations for given forces in turn, from outer control. The pitch
/// angles, creeps and frictions that go from one to the other hardly depend on what they change; a
/// combined load at very high speed or with nearly unloaded balls may not settle (1 to 2 % of wild
/// states), and the report says so.
///
/// Domain:   as solve_bearing_equilibrium(); at standstill the attitudes move nothing.
///           `options.race_control` and `rotations` are not looked at.
/// Accuracy: 1e-8 on the forces of each ball. Physically that of traction at small slip: angles
///           0.1 degrees in a full film, where traction hardly holds anything; between a film and
///           boundary friction the pitch angle follows the asperities' share of load.
[[nodiscard]] BalancedEquilibrium solve_balanced_equilibrium(
    const bearing::Bearing& bearing, const bearing::OperatingPoint& point, const OilState& oil,
    const ContactLaw& law, const bearing::EquilibriumOptions& options = {});

/// Friction of a bearing in balance whose balls turn so; as bearing_friction() by race control.
[[nodiscard]] BearingFriction bearing_friction(const bearing::Bearing& bearing,
                                               const BalancedEquilibrium& balanced, double speed,
                                               const OilState& oil, const ContactLaw& law);

}  // namespace raceway::friction::contact
