#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "correction/model.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::results {

/// Form of gain K(P) and time constant T(P) over the power loss P in a correction.
enum class StepLaw {
  curve,  ///< table through all points, with K(0) = 0
  power,  ///< K = a P^b, T = c P^d
  line    ///< published form: a straight line
};

/// Power loss of a spindle at a speed.
struct PowerAtSpeed {
  double speed = unset;  ///< [rad/s], > 0
  double power = unset;  ///< [W]
};

/// Data of a correction in addition to the step responses.
struct StepCorrectionParts {
  std::string name = {};                              ///< name of the model
  std::vector<PowerAtSpeed> power = {};               ///< in order of rising speed
  std::optional<shaft::KinematicLaw> kinematic = {};  ///< kinematic law; empty: none
  StepLaw law = StepLaw::curve;
  bool two_lags = false;  ///< true: a fast and a slow delay element
};

/// Returns the channel name of a load at a speed, such as "axial_load_4000rpm".
[[nodiscard]] std::string load_channel(spindle::Stepped stepped, double speed);

/// Returns a model with delay elements driven by the friction power at the speed. Each stepped load
/// has two channels for each of its speeds: an instant part and a thermal part. The instant part is
/// weighted by a share that depends on the speed. The share is 1 at the speed of the channel and 0
/// at the neighbouring speeds, with linear interpolation between them. Beyond the first and the
/// last speed the share is 1. The thermal part is a delay element whose input is the load times
/// this share. For the thermal part, the share falls to 0 at standstill.
///
/// Throws std::invalid_argument without a step response, without a power above 0, and for a law or
/// lags that the step responses do not determine.
[[nodiscard]] correction::Model step_model(const spindle::StepResponses& responses,
                                           const StepCorrectionParts& parts);

/// A model for `raceway correct`, with its tables by file name.
struct StepCorrection {
  std::string model = {};
  std::vector<std::pair<std::string, std::string>> tables = {};
};

/// Returns the text and the tables of a model from step_model(). Tables are in the folder of
/// `path`. The names of the tables begin with the name of the model file: c_friction.csv for
/// c.toml.
[[nodiscard]] StepCorrection step_correction(const correction::Model& model,
                                             const std::string& path);

/// Returns the paths of all tables that step_correction() may write for `path`, including the
/// tables for load channels.
[[nodiscard]] std::vector<std::string> step_correction_tables(
    const std::string& path, const std::vector<std::string>& load_channels = {});

/// Writes all files, tables first.
void write_step_correction(const StepCorrection& correction, const std::string& path, bool replace);

}  // namespace raceway::results
