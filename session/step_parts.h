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
/// temperature [C]. If `temperature` is NaN, the rig temperature of the model is used. Throws
/// std::invalid_argument if this operating point has no equilibrium.
[[nodiscard]] double friction_power(const model::Model& model, double speed, double temperature);

/// Returns the displacement [m] that the bearing sets cause at a speed [rad/s] without heating.
[[nodiscard]] double kinematic_at(const model::Model& model, double speed);

/// Data that a correction needs in addition to the laws for gain and time constant: the power as a
/// function of speed, and the kinematic displacement.
struct StepParts {
  std::vector<results::PowerAtSpeed> power = {};
  std::optional<shaft::KinematicLaw> kinematic = {};
  std::vector<std::string> notes = {};
};

/// Returns the friction power as a function of speed, and the kinematic law, for a correction. If
/// the steps in `responses` have speeds, the powers are the final powers of these steps. Otherwise
/// the powers are calculated from the friction of the model, up to the largest power in
/// `responses`. The kinematic law is fitted to the displacement of the model over speed. If `model`
/// is null, the law is fitted to the displacements that the steps in `responses` cause without
/// delay. `temperature` is the lubricant temperature for the friction [C]; NaN means the rig
/// temperature of the model.
[[nodiscard]] StepParts step_parts(const spindle::StepResponses& responses,
                                   const model::Model* model, double temperature);

}  // namespace raceway::session
