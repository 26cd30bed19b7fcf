#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/step_correction.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::session {

/// "6000 rpm", or the name of a load case.
[[nodiscard]] std::string name_of(const spindle::StepResponse& step);

/// Friction loss of all bearings of a shaft at a speed, at a temperature [C]; NaN: that of the rig
/// [W]. Throws std::invalid_argument where it does not balance.
[[nodiscard]] double friction_power(const model::Model& model, double speed, double temperature);

/// What its sets alone move by at a speed [m].
[[nodiscard]] double kinematic_at(const model::Model& model, double speed);

/// Of a correction, what step responses do not tell: power over speed, and what moves at once.
struct StepParts {
  std::vector<results::PowerAtSpeed> power = {};
  std::optional<shaft::KinematicLaw> kinematic = {};
  std::vector<std::string> notes = {};
};

/// Powers are those of the steps where these have speeds, else by the friction of the model up to
/// the largest of them. The kinematic law is that of the model, else of what the steps have at
/// once. `model` may be null.
[[nodiscard]] StepParts step_parts(const spindle::StepResponses& responses,
                                   const model::Model* model, double temperature);

}  // namespace raceway::session
