#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "correction/model.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::results {

/// Law for the gain K(P) and the time constant T(P) of a correction. P is the power loss, or the
/// load for load steps.
enum class StepLaw {
  curve,  ///< table of K and T of all steps, with K(0) = 0
  power,  ///< K = a P^b, T = c P^d
  line    ///< straight lines K(P) and T(P), as published [Brecher2021, eq. 8 and 9]
};

/// Power loss of all bearings of a spindle at one speed.
struct PowerAtSpeed {
  double speed = unset;  ///< [rad/s], > 0
  double power = unset;  ///< [W]
};

/// Values that a correction needs in addition to the step responses.
struct StepCorrectionParts {
  std::string name = {};                              ///< name of the model
  std::vector<PowerAtSpeed> power = {};               ///< in ascending order of speed
  std::optional<shaft::KinematicLaw> kinematic = {};  ///< kinematic law; empty: none
  StepLaw law = StepLaw::curve;
  bool two_lags = false;  ///< true: two delay elements, fast and slow
};

/// Returns the name of the correction channel for load steps at a speed [rad/s], such as
/// "axial_load_4000rpm".
[[nodiscard]] std::string load_channel(spindle::Stepped stepped, double speed);

/// Returns a correction model from step responses. For speed steps, the input of the delay elements
/// is the friction power at the present speed. For load steps, each speed has two channels: an
/// immediate displacement and a thermal displacement. Each channel has a weight that depends on the
/// speed. The weight is 1 at the speed of its load steps and 0 at the neighbouring speeds with load
/// steps, and linear between them. Above the highest of these speeds, the weight of its channels
/// stays 1. Below the lowest of these speeds, the weight of its immediate displacement stays 1, and
/// the weight of its thermal displacement falls linearly to 0 at standstill. The immediate
/// displacement is multiplied by the weight. The thermal displacement is a delay element whose
/// input is load times weight.
///
/// Throws std::invalid_argument if `parts.power` is empty, if no step response converged (with
/// `two_lags`: if none has two time constants), or if the step responses do not determine the law.
[[nodiscard]] correction::Model step_model(const spindle::StepResponses& responses,
                                           const StepCorrectionParts& parts);

/// Text of a model file for `raceway correct`, and path and text of each table of the model.
struct StepCorrection {
  std::string model = {};
  std::vector<std::pair<std::string, std::string>> tables = {};
};

/// Returns the texts of the model file `path` and of its tables for a model from step_model(). The
/// tables are in the folder of `path`. Their names begin with the name of the model file, such as
/// c_friction.csv for c.toml.
[[nodiscard]] StepCorrection step_correction(const correction::Model& model,
                                             const std::string& path);

/// Returns the paths of all tables that step_correction() may return for the model file `path` and
/// these load channels.
[[nodiscard]] std::vector<std::string> step_correction_tables(
    const std::string& path, const std::vector<std::string>& load_channels = {});

/// Writes the tables and then the model file `path`. If `replace` is false and a file exists,
/// throws InputError.
void write_step_correction(const StepCorrection& correction, const std::string& path, bool replace);

}  // namespace raceway::results
