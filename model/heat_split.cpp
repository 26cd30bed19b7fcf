#include "model/heat_split.h"

#include "friction/roller_friction.h"
#include "model/steps.h"

namespace raceway::model {

namespace {

friction::HeatSplit heat_of_rollers(const Model& model, const bearing::OperatingPoint& point,
                                    const FrictionPrediction& prediction) {
  friction::BaseMoments<double> moments{prediction.load, prediction.viscous};
  // The place of an added moment is not known.
  for (const double moment : prediction.effects) moments.viscous += moment;
  friction::BearingState<double> state = bearing_state(model, point, nullptr);
  state.roller_equilibrium = prediction.rollers.get();
  return friction::split_heat(roller_state(state), moments);
}

}  // namespace

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

friction::HeatSplit heat_split(const Model& model, const bearing::OperatingPoint& point,
                               const FrictionPrediction& prediction) {
  if (prediction.rollers) return heat_of_rollers(model, point, prediction);
  return heat_split(model, point, *prediction.equilibrium, prediction);
}

}  // namespace raceway::model
