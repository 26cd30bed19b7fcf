#pragma once

#include <span>

#include "model/model.h"

namespace raceway::model {

/// Oil properties from which the rotation of the balls is computed if the model does not assume
/// race control. With race control, all members are zero.
struct BallTurning {
  double temperature = 0.0;                                 ///< temperature of the oil [K]
  double viscosity_40C = 0.0, viscosity_100C = 0.0;         ///< [m²/s]
  double boundary_friction = 0.0, limiting_traction = 0.0;  ///< [1]
  [[nodiscard]] bool operator==(const BallTurning&) const = default;
};
[[nodiscard]] BallTurning ball_turning(const Model& model, const friction::Lubricant& oil,
                                       double temperature);

/// Solves the ball equilibrium of a bearing. If the model assumes race control, the rotation of the
/// balls follows from this assumption. Otherwise, the rotation follows from the oil traction at the
/// temperature of the operating point. `bearing` and `oil` may differ from the bearing and the oil
/// of the model. The iteration starts from the known solution `neighbour`, if it is given.
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
