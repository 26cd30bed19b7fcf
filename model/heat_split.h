#pragma once

#include "friction/heat.h"
#include "model/prediction.h"

namespace raceway::model {

/// Heat of a predicted friction by ring: an effect of spin heats where the balls spin, all other
/// effects as film shear. `equilibrium` belongs to the prediction. The sum over the rings is torque
/// times speed, to rounding.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium& equilibrium,
                                             const FrictionPrediction& prediction);

/// Heat by ring, with the balls or rollers in balance in the prediction.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const FrictionPrediction& prediction);

}  // namespace raceway::model
