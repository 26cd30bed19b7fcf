#include "session/beam_of_model.h"

#include <fmt/format.h>

#include <stdexcept>

#include "text/error.h"

namespace raceway::session {

BeamOfModel beam_of(const files::ModelFile& file, double load_place) {
  const model::Model& model = file.model;
  if (!model.spindle || model.spindle->shaft.segments.empty())
    throw text::InputError(file.source +
                               ": has no [shaft] with segments: length_mm and diameter_mm of each "
                               "piece from the nose to the rear are needed",
                           {.file = file.source, .key = "shaft.segment"});
  try {
    const std::vector<double> places = spindle::bearing_places(*model.spindle);
    std::vector<double> nodes = places;
    nodes.push_back(load_place);
    spindle::Beam beam(model.spindle->shaft, nodes);
    return {places, std::move(beam), spindle::SetsOfSpindle(model)};
  } catch (const std::invalid_argument& e) {
    throw text::InputError(fmt::format("{}: {}", file.source, e.what()), {.file = file.source});
  }
}

std::string unused_coolant_off(const model::Model& model, bool coolant_on, bool warm) {
  if (coolant_on) return {};
  if (!model.spindle || !model.spindle->coolant)
    return "switching the coolant off changes nothing: the model has no [coolant]";
  if (!warm) return "switching the coolant off changes nothing: the spindle is cold, not warm";
  return {};
}

spindle::Inputs inputs_at(const model::Model& model, double speed, bool coolant_on) {
  return {.speed = speed, .axial_load = model.shaft->external_load, .coolant_on = coolant_on};
}

}  // namespace raceway::session
