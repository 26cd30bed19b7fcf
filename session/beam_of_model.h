#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "spindle/beam.h"
#include "spindle/sets_at_speed.h"

namespace raceway::session {

/// A spindle as a beam on its bearings, for deflection and modes.
struct BeamOfModel {
  std::vector<double> places;         ///< of the bearings of the sets [m]
  std::vector<double> roller_places;  ///< [m]
  std::vector<std::string> roller_names;
  spindle::Beam beam;
  spindle::SetsOfSpindle sets;
};

/// Nodes at the bearings and at `load_place` [m]. Throws text::InputError for a model that has no
/// [shaft] with segments, and with the file's name before what is wrong with it.
[[nodiscard]] BeamOfModel beam_of(const files::ModelFile& file, double load_place);

/// The shaft on all its bearings under belt and nose loads of the inputs and, where there is one,
/// a further load at a node of the beam.
[[nodiscard]] spindle::LoadedShaft bend(const model::Model& model, const BeamOfModel& b,
                                        const spindle::SetsAtSpeed& sets,
                                        const spindle::Inputs& inputs,
                                        const spindle::ShaftLoad* further = nullptr);

/// Tangent stiffness of all bearings: the sets as SetsAtSpeed has them, and the rollers of the bent
/// shaft.
[[nodiscard]] std::vector<spindle::Spring> springs_of(
    const BeamOfModel& b, const spindle::SetsAtSpeed& sets,
    const std::optional<spindle::LoadedShaft>& bent);

/// True if anything but a further load bends the shaft, or rollers hold it.
[[nodiscard]] bool bends(const model::Spindle& spindle);

/// Why a coolant that is switched off changes nothing, a note; empty where it does.
[[nodiscard]] std::string unused_coolant_off(const model::Model& model, bool coolant_on, bool warm);

/// Conditions of the sets: the external load of the model and, warm, its ambient.
[[nodiscard]] spindle::Inputs inputs_at(const model::Model& model, double speed, bool coolant_on);

}  // namespace raceway::session
