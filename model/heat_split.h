#pragma once

#include "friction/heat.h"
#include "model/prediction.h"

namespace raceway::model {

/// Splits the heat of a predicted friction between the rings. Effects of spin heat the contacts in
/// which the balls spin; all other effects are split like film shear. `equilibrium` is the
/// equilibrium of the prediction. The sum over the rings equals torque times speed to within
/// rounding error.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium& equilibrium,
                                             const FrictionPrediction& prediction);

/// Returns the heat by ring, with balls or rollers from the prediction.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const FrictionPrediction& prediction);

}  // namespace raceway::model
