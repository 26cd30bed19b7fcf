#pragma once

#include <span>

#include "model/model.h"

namespace raceway::model {

/// Inputs of the ball rotation without race control; all zero under race control. A change of these
/// changes the balance.
struct BallTurning {
  double temperature = 0.0;                                 ///< of the oil [K]
  double viscosity_40C = 0.0, viscosity_100C = 0.0;         ///< [m²/s]
  double boundary_friction = 0.0, limiting_traction = 0.0;  ///< [1]
  [[nodiscard]] bool operator==(const BallTurning&) const = default;
};
[[nodiscard]] BallTurning ball_turning(const Model& model, const friction::Lubricant& oil,
                                       double temperature);

/// Balance of a bearing as the model's solver has it: by race control, or, where no race holds the
/// balls, with the oil at the temperature of the point. `bearing` may be another one than the
/// model's, and `oil`; from a neighbour where there is one.
[[nodiscard]] bearing::BearingEquilibrium solve_balls(
    const Model& model, const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
    const bearing::EquilibriumOptions& options, const friction::Lubricant& oil,
    const bearing::BearingEquilibrium* neighbour = nullptr);

/// Balance of the sets. `temperatures`: of the oil in each bearing, or one for all [K].
[[nodiscard]] bearing::ArrangementEquilibrium solve_sets(
    const Model& model, const bearing::Arrangement& arrangement,
    const bearing::ArrangementCondition& condition, std::span<const double> temperatures,
    const bearing::ArrangementEquilibrium* neighbour = nullptr);

}  // namespace raceway::model
