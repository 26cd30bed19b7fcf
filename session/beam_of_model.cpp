#include "session/beam_of_model.h"

#include <fmt/format.h>

#include <stdexcept>

#include "text/error.h"

namespace raceway::session {

BeamOfModel beam_of(const files::ModelFile& file, double load_place) {
  const model::Model& model = file.model;
  if (!model.spindle || model.spindle->shaft.segments.empty())
    throw text::InputError(file.source +
                               ": the model has no [shaft] with segments: give length_mm and "
                               "diameter_mm of each segment, from the nose to the rear",
                           {.file = file.source, .key = "shaft.segment"});
  try {
    const std::vector<double> places = spindle::bearing_places(*model.spindle);
    std::vector<double> nodes = spindle::beam_places(*model.spindle);
    nodes.push_back(load_place);
    spindle::Beam beam(model.spindle->shaft, nodes);
    std::vector<double> of_rollers;
    std::vector<std::string> names;
    for (const model::RollerOnShaft& r : model.spindle->rollers) {
      of_rollers.push_back(r.position);
      names.push_back(r.name);
    }
    return {places, std::move(of_rollers), std::move(names), std::move(beam),
            spindle::SetsOfSpindle(model)};
  } catch (const std::invalid_argument& e) {
    throw text::InputError(fmt::format("{}: {}", file.source, e.what()), {.file = file.source});
  }
}

spindle::LoadedShaft bend(const model::Model& model, const BeamOfModel& b,
                          const spindle::SetsAtSpeed& sets, const spindle::Inputs& inputs,
                          const spindle::ShaftLoad* further) {
  std::vector<spindle::ShaftLoad> loads = spindle::shaft_loads(*model.spindle, inputs);
  std::erase_if(loads, [](const spindle::ShaftLoad& l) { return !l.pushes_across(); });
  if (further) loads.push_back(*further);
  std::vector<double> places;
  for (const spindle::ShaftLoad& load : loads) places.push_back(load.position);
  // Balls that no race holds turn as they do without the load.
  const std::vector<bearing::GivenRotation> rotations = sets.equilibrium.rotations();
  bearing::EquilibriumOptions options = model.solver;
  options.rotations = rotations;
  return spindle::ShaftOnBearings(
             b.beam, spindle::bearings_of_shaft(*model.spindle, b.sets.arrangement()), places)
      .solve(sets.condition, sets.clearances, loads, options);
}

std::vector<spindle::Spring> springs_of(const BeamOfModel& b, const spindle::SetsAtSpeed& sets,
                                        const std::optional<spindle::LoadedShaft>& bent) {
  std::vector<spindle::Spring> springs =
      spindle::bearing_springs(b.sets.arrangement(), b.places, sets.bearings);
  for (std::size_t k = 0; bent && k < bent->rollers.size(); ++k)
    springs.push_back(spindle::roller_spring(b.roller_places[k], bent->rollers[k]));
  return springs;
}

bool bends(const model::Spindle& spindle) {
  return !spindle.rollers.empty() || (spindle.belt && spindle.belt->force != 0.0);
}

std::string unused_coolant_off(const model::Model& model, bool coolant_on, bool warm) {
  if (coolant_on) return {};
  if (!model.spindle || !model.spindle->coolant)
    return "switching off the coolant has no effect: the model has no [coolant]";
  if (!warm)
    return "switching off the coolant has no effect: the spindle is calculated cold, not warm";
  return {};
}

spindle::Inputs inputs_at(const model::Model& model, double speed, bool coolant_on) {
  return {.speed = speed, .axial_load = model.shaft->external_load, .coolant_on = coolant_on};
}

}  // namespace raceway::session
