#pragma once

#include <span>

#include "model/model.h"

namespace raceway::model {

/// Oil properties that determine the rotation of the balls without race control. All members are
/// zero with race control.
struct BallTurning {
  double temperature = 0.0;                                 ///< temperature of the oil [K]
  double viscosity_40C = 0.0, viscosity_100C = 0.0;         ///< [m²/s]
  double boundary_friction = 0.0, limiting_traction = 0.0;  ///< [1]
  [[nodiscard]] bool operator==(const BallTurning&) const = default;
};
[[nodiscard]] BallTurning ball_turning(const Model& model, const friction::Lubricant& oil,
                                       double temperature);

/// Solves the ball equilibrium of a bearing with the solver of the model: with race control or, if
/// no race controls the balls, with the traction of the oil at the temperature of the point.
/// `bearing` and `oil` may differ from the bearing and the oil of the model. The solve starts from
/// a neighbouring solution if one is given.
[[nodiscard]] bearing::BearingEquilibrium solve_balls(
    const Model& model, const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
    const bearing::EquilibriumOptions& options, const friction::Lubricant& oil,
    const bearing::BearingEquilibrium* neighbour = nullptr);

/// Solves the equilibrium of the bearing sets. `temperatures` are oil temperatures [K], one for
/// each bearing or one for all bearings.
[[nodiscard]] bearing::ArrangementEquilibrium solve_sets(
    const Model& model, const bearing::Arrangement& arrangement,
    const bearing::ArrangementCondition& condition, std::span<const double> temperatures,
    const bearing::ArrangementEquilibrium* neighbour = nullptr);

}  // namespace raceway::model
