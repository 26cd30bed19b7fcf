#pragma once

#include "fit/prediction.h"
#include "friction/heat.h"

namespace raceway::fit {

/// Heat of a predicted friction by ring; the spin of `spin-friction` where it arises, all other
/// effects as film shear. `equilibrium` is that of the prediction.
[[nodiscard]] friction::HeatSplit heat_split(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium& equilibrium,
                                             const FrictionPrediction& prediction);

}  // namespace raceway::fit
