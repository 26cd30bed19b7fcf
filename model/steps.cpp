#include "model/steps.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "model/balance.h"

namespace raceway::model {

bool needs_equilibrium(const Model& model) {
  return friction::needs_equilibrium(model.law) ||
         std::any_of(model.effects.begin(), model.effects.end(), [](const effects::Effect& effect) {
           return effect.description->needs_equilibrium;
         });
}

Steps::Steps(const Model& model, bool with_equilibrium, const record::Channel& read)
    : equilibrium(with_equilibrium || needs_equilibrium(model)),
      needs_balls(needs_equilibrium(model)) {
  // What rollers carry is asked for, or counted by the law.
  if (model.bearing.rollers() && model.f1_load == friction::F1Load::rollers)
    equilibrium = needs_balls = true;
  for (std::size_t k = 0; k < model.effects.size(); ++k) {
    const effects::Description& d = *model.effects[k].description;
    if (d.entry) entry.push_back(k);
    if (d.condition) condition.push_back(k);
    if (d.lubricant) lubricant.push_back(k);
    if (d.has_moment()) moment.push_back(k);
    if (d.reads(read)) reading.push_back(k);
  }
  // Descriptions of the catalogue stand in one array, in its order.
  for (auto* list : {&entry, &lubricant})
    std::stable_sort(list->begin(), list->end(), [&](std::size_t a, std::size_t b) {
      return std::less<>()(model.effects[a].description, model.effects[b].description);
    });
}

Stage first_stage(const Model& model, const Steps& steps, int effect) {
  if (effect < 0) {
    if (model.balanced_balls) return Stage::condition;  // traction turns the balls
    // Effects on condition and lubricant may look at the power of the base law.
    if (!steps.condition.empty()) return Stage::condition;
    return steps.lubricant.empty() ? Stage::base : Stage::lubricant;
  }
  const effects::Description& d = *model.effects[static_cast<std::size_t>(effect)].description;
  if (d.entry) return Stage::entry;
  if (d.condition) return Stage::condition;
  if (d.lubricant) return Stage::lubricant;
  return d.has_moment() ? Stage::moment : Stage::reading;
}

friction::BearingState<double> bearing_state(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium* equilibrium) {
  friction::BearingState<double> state;
  state.bearing = model.bearing.ball_bearing();
  state.rollers = model.bearing.rollers();
  state.equilibrium = equilibrium;
  state.race_control = model.solver.race_control;
  state.f1_load = model.f1_load;
  state.lubricant = &model.lubricant;
  state.contact = &model.contact;
  state.table = model.table.get();
  state.speed = point.speed;
  state.axial_load = point.axial_load;
  state.radial_load = std::hypot(point.radial_load, point.radial_load_z);
  state.temperature = point.temperature;
  state.kinematic_viscosity = model.lubricant.kinematic_viscosity(point.temperature);
  return state;
}

bool uses_power(const Model& model, const Steps& steps) {
  return std::any_of(steps.condition.begin(), steps.condition.end(),
                     [&](std::size_t k) { return model.effects[k].description->uses_power; });
}

double entered_power(const Model& model, friction::BearingState<double> entered,
                     const bearing::OperatingPoint& point) {
  bearing::BearingEquilibrium balls;
  if (friction::needs_equilibrium(model.law)) {
    balls = solve_balls(model, *entered.bearing, point, model.solver, *entered.lubricant);
    entered.equilibrium = &balls;
  }
  const friction::BaseMoments<double> base =
      effects::BaseLaw{model.law, model.law_values}.moments(entered);
  return (base.load + base.viscous) * point.speed;
}

effects::Condition condition_of(const Model& model, const Steps& steps,
                                const friction::BearingState<double>& entered,
                                const bearing::OperatingPoint& point, const effects::Record& record,
                                const effects::Condition& given) {
  return condition_of(model, steps, entered, point, record, given,
                      uses_power(model, steps) ? entered_power(model, entered, point) : unset);
}

effects::Condition condition_of(const Model& model, const Steps& steps,
                                const friction::BearingState<double>& entered,
                                const bearing::OperatingPoint& point, const effects::Record& record,
                                const effects::Condition& given, double power) {
  effects::Condition condition = given;
  if (steps.condition.empty()) return condition;
  const effects::ConditionInputs inputs{
      .bearing = *entered.bearing, .point = point, .record = record, .power = power};
  for (const std::size_t k : steps.condition)
    model.effects[k].description->condition(inputs, model.effects[k].values, condition);
  return condition;
}

}  // namespace raceway::model
