#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "correction/model.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::results {

/// Form of K(P) and T(P) in a correction.
enum class StepLaw {
  curve,  ///< through all points, K(0) = 0, as a table
  power,  ///< K = a P^b, T = c P^d
  line    ///< as published: a chord
};

/// Power loss of a spindle that turns at a speed.
struct PowerAtSpeed {
  double speed = unset;  ///< [rad/s], > 0
  double power = unset;  ///< [W]
};

/// Data of a correction in addition to the step responses.
struct StepCorrectionParts {
  std::string name = {};                              ///< of the model
  std::vector<PowerAtSpeed> power = {};               ///< rising in speed
  std::optional<shaft::KinematicLaw> kinematic = {};  ///< none: nothing moves at once
  StepLaw law = StepLaw::curve;
  bool two_lags = false;  ///< a fast and a slow delay element
};

/// Name of the channel of a load at a speed, "axial_load_4000rpm".
[[nodiscard]] std::string load_channel(spindle::Stepped stepped, double speed);

/// Delay elements driven by the friction power at the speed. Loads that stepped have two channels
/// for each of their speeds. What comes at once counts by a share of the speed: 1 at that speed, 0
/// at its neighbours, straight between, 1 beyond the first and the last. What a load heats is a
/// delay element whose input is the load times that share, which falls to 0 at rest.
///
/// Throws std::invalid_argument: no step response, no power above 0, a law or lags that these step
/// responses do not carry.
[[nodiscard]] correction::Model step_model(const spindle::StepResponses& responses,
                                           const StepCorrectionParts& parts);

/// A model for `raceway correct`, and the tables that it names, by their file.
struct StepCorrection {
  std::string model = {};
  std::vector<std::pair<std::string, std::string>> tables = {};
};

/// The text of such a model. Tables stand in the folder of `path`, their names begin with its name:
/// c_friction.csv of c.toml.
[[nodiscard]] StepCorrection step_correction(const correction::Model& model,
                                             const std::string& path);

/// Paths of the tables that step_correction() may write for `path`, also for channels of loads.
[[nodiscard]] std::vector<std::string> step_correction_tables(
    const std::string& path, const std::vector<std::string>& load_channels = {});

/// Writes all of it, tables first.
void write_step_correction(const StepCorrection& correction, const std::string& path, bool replace);

}  // namespace raceway::results
