#pragma once

#include "friction/heat.h"
#include "model/prediction.h"

namespace raceway::model {

/// Splits the friction heat of a ball bearing between the inner and the outer ring [W].
/// `equilibrium` is the ball equilibrium for which the friction was predicted. The heat of the
/// effect spin-friction enters the rings at the contacts in which the balls spin. The heat of all
/// other effects is split like the viscous friction: see friction::split_heat(). The sum over both
/// rings equals torque times speed, to within rounding error.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium& equilibrium,
                                             const FrictionPrediction& prediction);

/// Splits the friction heat of a ball or roller bearing between the inner and the outer ring [W].
/// `prediction` must contain the equilibrium of the balls or rollers.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const FrictionPrediction& prediction);

}  // namespace raceway::model
