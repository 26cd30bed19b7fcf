#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/step_correction.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::session {

/// Returns "6000 rpm", "-500 N axial at 6000 rpm", or the name of a load case.
[[nodiscard]] std::string name_of(const spindle::StepResponse& step);

/// Returns the friction loss of all bearings of a shaft [W] at a speed and a temperature [C]. NaN
/// means the temperature of the rig. Throws std::invalid_argument if the point has no equilibrium.
[[nodiscard]] double friction_power(const model::Model& model, double speed, double temperature);

/// Returns the displacement that the bearing sets alone cause at a speed [m].
[[nodiscard]] double kinematic_at(const model::Model& model, double speed);

/// Parts of a correction in addition to the laws K(P) and T(P): power over speed, and kinematic
/// displacement.
struct StepParts {
  std::vector<results::PowerAtSpeed> power = {};
  std::optional<shaft::KinematicLaw> kinematic = {};
  std::vector<std::string> notes = {};
};

/// Returns these parts of a correction. Powers come from the steps if the steps give speeds.
/// Otherwise the powers come from the friction of the model, up to the largest power of the steps.
/// The kinematic law comes from the model. Without a model, this law comes from the immediate
/// displacements of the steps. `model` may be null.
[[nodiscard]] StepParts step_parts(const spindle::StepResponses& responses,
                                   const model::Model* model, double temperature);

}  // namespace raceway::session
