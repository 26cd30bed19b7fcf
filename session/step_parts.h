#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/step_correction.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::session {

/// Returns the name of a step: "6000 rpm", "-500 N axial at 6000 rpm", or the name of a load case.
[[nodiscard]] std::string name_of(const spindle::StepResponse& step);

/// Returns the friction loss of all bearings of a shaft [W] at a speed [rad/s] and a lubricant
/// temperature [C]. NaN means the rig temperature of the model. Throws std::invalid_argument if the
/// point has no equilibrium.
[[nodiscard]] double friction_power(const model::Model& model, double speed, double temperature);

/// Returns the displacement [m] that the bearing sets cause at a speed [rad/s] without heating.
[[nodiscard]] double kinematic_at(const model::Model& model, double speed);

/// Parts of a correction in addition to the laws for gain and time constant over power: power over
/// speed, and kinematic displacement.
struct StepParts {
  std::vector<results::PowerAtSpeed> power = {};
  std::optional<shaft::KinematicLaw> kinematic = {};
  std::vector<std::string> notes = {};
};

/// Returns power over speed and the kinematic law for a correction. If the steps give speeds, the
/// powers come from the steps. Otherwise the powers come from the friction of the model, up to the
/// largest power of the steps. The kinematic law comes from the model. If `model` is null, this law
/// comes from the immediate displacements of the steps.
[[nodiscard]] StepParts step_parts(const spindle::StepResponses& responses,
                                   const model::Model* model, double temperature);

}  // namespace raceway::session
