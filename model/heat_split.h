#pragma once

#include "friction/heat.h"
#include "model/prediction.h"

namespace raceway::model {

/// Splits the friction heat of a prediction between the rings [W]. Spin effects heat the contacts
/// in which the balls spin. The heat of all other effects is split like the heat of film shear.
/// `equilibrium` is the equilibrium of the prediction. The sum over the rings equals torque times
/// speed to within rounding error.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium& equilibrium,
                                             const FrictionPrediction& prediction);

/// Returns the heat of each ring [W], with the equilibrium of balls or rollers in the prediction.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const FrictionPrediction& prediction);

}  // namespace raceway::model
