#include "fit/heat_split.h"

namespace raceway::fit {

friction::HeatSplit heat_split(const Model& model, const bearing::OperatingPoint& point,
                               const bearing::BearingEquilibrium& equilibrium,
                               const FrictionPrediction& prediction) {
  friction::HeatSources sources{.load = prediction.load, .viscous = prediction.viscous};
  for (std::size_t i = 0; i < prediction.effects.size(); ++i) {
    const effects::Effect& effect = model.effects[i];
    if (effect.description->id == "spin-friction") {
      sources.spin_coefficient += effect.values[0];
    } else {
      sources.viscous += prediction.effects[i];
    }
  }
  return friction::split_heat(bearing_state(model, point, &equilibrium), sources);
}

}  // namespace raceway::fit
