#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/model_file.h"
#include "spindle/beam.h"
#include "spindle/sets_at_speed.h"

namespace raceway::session {

/// Shaft of a spindle as an elastic beam on its bearings, for the calculation of deflection and
/// natural vibration modes.
struct BeamOfModel {
  /// Distances of the ball bearings from the nose face of the shaft [m].
  std::vector<double> places;
  std::vector<double> roller_places;  ///< distances from the nose face to the roller bearings [m]
  std::vector<std::string> roller_names;
  spindle::Beam beam;
  spindle::SetsOfSpindle sets;
};

/// Returns the beam of a model with nodes at the bearings and at `load_place`, the distance of a
/// load from the nose face [m]. Throws text::InputError if the model has no [shaft] with segments.
/// Error messages begin with the name of the file.
[[nodiscard]] BeamOfModel beam_of(const files::ModelFile& file, double load_place);

/// Computes the bending of the shaft on all its bearings under the belt force and the nose loads in
/// `inputs`. `further` is an additional load at one node of the beam; null without such a load.
[[nodiscard]] spindle::LoadedShaft bend(const model::Model& model, const BeamOfModel& b,
                                        const spindle::SetsAtSpeed& sets,
                                        const spindle::Inputs& inputs,
                                        const spindle::ShaftLoad* further = nullptr);

/// Returns the tangent stiffness of the bearings. `sets` gives the stiffness of the bearing sets.
/// `bent`, the result of bend(), gives the stiffness of the roller bearings. If `bent` is empty,
/// the result contains only the springs of the bearing sets.
[[nodiscard]] std::vector<spindle::Spring> springs_of(
    const BeamOfModel& b, const spindle::SetsAtSpeed& sets,
    const std::optional<spindle::LoadedShaft>& bent);

/// Returns true if roller bearings support the shaft or a belt force bends it. Loads at the nose
/// are not considered.
[[nodiscard]] bool bends(const model::Spindle& spindle);

/// Returns the reason why a request to switch off the coolant has no effect: the model has no
/// coolant, or the spindle is calculated cold (`warm` is false). The text is empty if `coolant_on`
/// is true (no request), or if the request has an effect.
[[nodiscard]] std::string unused_coolant_off(const model::Model& model, bool coolant_on, bool warm);

/// Returns the inputs of a spindle at a speed, with the external load of the model. All
/// temperatures are NaN: a calculation then uses the temperatures of the model.
[[nodiscard]] spindle::Inputs inputs_at(const model::Model& model, double speed, bool coolant_on);

}  // namespace raceway::session
