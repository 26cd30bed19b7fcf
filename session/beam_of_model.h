#pragma once

#include <string>
#include <vector>

#include "files/model_file.h"
#include "spindle/beam.h"
#include "spindle/sets_at_speed.h"

namespace raceway::session {

/// A spindle as a beam on its bearings, for deflection and modes.
struct BeamOfModel {
  std::vector<double> places;  ///< of the bearings [m]
  spindle::Beam beam;
  spindle::SetsOfSpindle sets;
};

/// Nodes at the bearings and at `load_place` [m]. Throws text::InputError for a model that has no
/// [shaft] with segments, and with the file's name before what is wrong with it.
[[nodiscard]] BeamOfModel beam_of(const files::ModelFile& file, double load_place);

/// Why a coolant that is switched off changes nothing, a note; empty where it does.
[[nodiscard]] std::string unused_coolant_off(const model::Model& model, bool coolant_on, bool warm);

/// What the sets run under: the external load of the model and, warm, its ambient.
[[nodiscard]] spindle::Inputs inputs_at(const model::Model& model, double speed, bool coolant_on);

}  // namespace raceway::session
