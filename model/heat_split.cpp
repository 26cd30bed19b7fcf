#include "model/heat_split.h"

#include "model/steps.h"

namespace raceway::model {
friction::HeatSplit heat_split(const Model& model, const bearing::OperatingPoint& point,
                               const bearing::BearingEquilibrium& equilibrium,
                               const FrictionPrediction& prediction) {
  friction::HeatSources sources;
  if (!prediction.contacts) {
    sources.load = prediction.load;
    sources.viscous = prediction.viscous;
  }
  for (std::size_t i = 0; i < prediction.effects.size(); ++i) {
    const effects::Effect& effect = model.effects[i];
    if (effect.description->spin)
      sources.spin_coefficient += effect.values[0];
    else
      sources.viscous += prediction.effects[i];
  }
  friction::BearingState<double> state = bearing_state(model, point, &equilibrium);
  if (prediction.bearing) state.bearing = prediction.bearing.get();  // whose balls these are
  friction::HeatSplit heat = friction::split_heat(state, sources);
  if (prediction.contacts) {
    const friction::HeatSplit contacts = ring_heat(*prediction.contacts, point.speed);
    heat.inner += contacts.inner;
    heat.outer += contacts.outer;
  }
  return heat;
}

}  // namespace raceway::model
