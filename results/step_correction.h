#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "correction/model.h"
#include "shaft/kinematic_law.h"
#include "spindle/step_response.h"

namespace raceway::results {

/// Law for the gain K(P) and the time constant T(P) of a delay element. P is the load for load
/// steps, and the power loss of the bearings for speed steps.
enum class StepLaw {
  curve,  ///< smooth curves through K and T of all steps, with K(0) = 0
  power,  ///< K = a P^b, T = c P^d, with fitted a, b, c and d
  line    ///< straight lines K(P) and T(P), as published [Brecher2021, eq. 8 and 9]
};

/// Power loss of all bearings of a spindle at one speed.
struct PowerAtSpeed {
  double speed = unset;  ///< [rad/s], > 0
  double power = unset;  ///< [W]
};

/// Values that step_model() needs in addition to the step responses.
struct StepCorrectionParts {
  std::string name = {};  ///< name of the model
  /// Power losses of the bearings, in ascending order of speed.
  std::vector<PowerAtSpeed> power = {};
  /// Law of the displacement that follows the speed without delay; empty for a correction without
  /// this law.
  std::optional<shaft::KinematicLaw> kinematic = {};
  StepLaw law = StepLaw::curve;
  bool two_lags = false;  ///< true: a fast and a slow delay element; false: one element
};

/// Returns the name of the correction channel for load steps at a speed [rad/s], such as
/// "axial_load_4000rpm".
[[nodiscard]] std::string load_channel(spindle::Stepped stepped, double speed);

/// Returns a correction model from step responses. For speed steps, the input of the delay elements
/// is the friction power of all bearings at the present speed.
///
/// If `responses` contains load steps, the model has two channels for each speed at which the load
/// was changed: the immediate displacement, and the thermal displacement with a delay element. The
/// immediate displacement, and the load at the input of the delay element, are multiplied by a
/// weight. The weight depends on the present speed:
///   - At the speed of the channel, the weight is 1. From this speed to the next higher or lower
///     speed with load steps, the weight falls linearly to 0.
///   - Above the highest speed with load steps, the channels of this speed keep the weight 1.
///   - Below the lowest speed with load steps, the immediate displacement keeps the weight 1. The
///     weight of the thermal displacement falls linearly to 0 at standstill.
///
/// Throws std::invalid_argument in these cases:
///   - `parts.power` is empty.
///   - No step response converged, or `parts.two_lags` is true and no step response has two time
///     constants.
///   - StepLaw::line: the step responses belong to fewer than two different powers or loads.
///   - StepLaw::power: the step responses belong to fewer than two different powers or loads, a
///     power or load is not above 0, or the gains have different signs.
[[nodiscard]] correction::Model step_model(const spindle::StepResponses& responses,
                                           const StepCorrectionParts& parts);

/// Model file for `raceway correct`, and the tables that the model file names.
struct StepCorrection {
  std::string model = {};                                        ///< text of the model file
  std::vector<std::pair<std::string, std::string>> tables = {};  ///< path and text of each table
};

/// Returns the texts of the model file `path` and of its tables. `model` must come from
/// step_model(). The tables are in the folder of `path`. The name of each table begins with the
/// name of the model file, such as c_friction.csv for c.toml.
[[nodiscard]] StepCorrection step_correction(const correction::Model& model,
                                             const std::string& path);

/// Returns the paths of all tables that step_correction() may return for the model file `path` and
/// a correction with the load channels `load_channels`.
[[nodiscard]] std::vector<std::string> step_correction_tables(
    const std::string& path, const std::vector<std::string>& load_channels = {});

/// Writes the tables and then the model file `path`. Throws InputError if `replace` is false and
/// one of these files exists.
void write_step_correction(const StepCorrection& correction, const std::string& path, bool replace);

}  // namespace raceway::results
