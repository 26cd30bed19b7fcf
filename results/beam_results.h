#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bearing/frequencies.h"
#include "model/judgement.h"
#include "model/model.h"
#include "spindle/loaded_shaft.h"
#include "spindle/modes.h"
#include "spindle/sets_at_speed.h"
#include "spindle/unbalance.h"

/// Results of the shaft as a beam on its bearings, as CSV and as JSON, keys with their units
/// (docs/files.md). What has no balance is empty or null.
namespace raceway::results {

/// Modes at one speed, and the sets that hold the shaft there.
struct ModesAtSpeed {
  double speed = unset;  ///< [rad/s]
  spindle::SetsAtSpeed sets;
  std::vector<spindle::Spring> springs;
  std::optional<spindle::LoadedShaft> shaft = {};  ///< as DeflectionResult::unloaded
  std::vector<std::string> roller_names = {};
  spindle::Modes modes;
  /// Frequencies of all bearings, by name, per turn of the shaft.
  std::vector<std::pair<std::string, bearing::BearingFrequencies>> rolling = {};
  double damping_ratio = unset;             ///< as it was stated [1]
  std::optional<spindle::Orbit> nose = {};  ///< under the unbalance that was asked about
  [[nodiscard]] bool converged() const { return sets.converged() && modes.converged(); }
  /// "converged", or how sets or modes ended.
  [[nodiscard]] std::string status() const;
};

/// Meeting of a mode and an excitation that goes with the speed.
struct Crossing {
  std::string
      excitation;        ///< "1x", "2x", "front_1 cage", "front_1 outer race", "rear_1 inner race"
  std::size_t mode = 0;  ///< of its sense, the lowest is 1
  spindle::Whirl whirl = spindle::Whirl::forward;
  double speed = unset, frequency = unset;  ///< [rad/s]
};

/// Crossings of once and twice per turn, and of the cage, the outer and the inner race of every
/// bearing, with every mode, straight between the speeds; rising in speed. Of modes that
/// stand every other one counts as backward, the rest as forward.
[[nodiscard]] std::vector<Crossing> crossings(const std::vector<ModesAtSpeed>& speeds);

/// A Campbell diagram: speed_rpm, mode, frequency_Hz, whirl, damping_ratio (as stated, else empty),
/// front_force_N, rear_force_N and, of each side as sums and of each bearing, stiffness; the
/// frequencies of each bearing; with an unbalance the path of the nose; status. A row for each
/// mode, one without mode where there is none.
[[nodiscard]] std::string campbell_text(const bearing::Arrangement& arrangement,
                                        const std::vector<ModesAtSpeed>& speeds,
                                        std::string_view source, std::string_view model_text);

/// speed_rpm, mode, frequency_Hz, whirl, position_mm, y_amplitude, z_amplitude; the largest is 1.
[[nodiscard]] std::string mode_shapes_text(const spindle::Beam& beam,
                                           const std::vector<ModesAtSpeed>& speeds,
                                           std::string_view source, std::string_view model_text);

[[nodiscard]] std::string campbell_json(const bearing::Arrangement& arrangement,
                                        const std::vector<ModesAtSpeed>& speeds,
                                        std::string_view source,
                                        const model::Findings& findings = {});

/// The shaft under a force.
struct DeflectionResult {
  double speed = 0.0, force = unset, at = 0.0;  ///< [rad/s], [N], [m]
  bool axial = false;
  double axial_force = 0.0;  ///< with a radial one, towards the tool [N]
  /// In the plane of a radial force, at its place, in the sense of the same force further in front
  /// [N m].
  double moment = 0.0;
  spindle::SetsAtSpeed sets;   ///< without the force
  spindle::LoadedShaft shaft;  ///< under it; not run where the sets have no balance
  /// Without the force, where a belt bends the shaft or rollers hold it.
  std::optional<spindle::LoadedShaft> unloaded = {};
  std::vector<std::string> roller_names = {};
  double displacement = unset;  ///< where the force acts, in its direction [m]
  double nose = unset;          ///< of the nose face in that direction [m]
  double slope = unset;         ///< of the section at the nose [rad]
  double tangent = unset;  ///< displacement where the force acts, by the unloaded stiffness [m]
  [[nodiscard]] bool converged() const { return sets.converged() && shaft.report.converged(); }
  [[nodiscard]] std::string status() const;
  /// For one force alone; NaN for several loads together [N/m].
  [[nodiscard]] double stiffness() const {
    return axial_force == 0.0 && moment == 0.0 ? force / displacement : unset;
  }
};

/// "1000 N radial, -200 N axial, 50 N m".
[[nodiscard]] std::string load_words(const DeflectionResult& result);

[[nodiscard]] std::string deflection_json(const bearing::Arrangement& arrangement,
                                          const DeflectionResult& result, std::string_view source,
                                          const model::Findings& findings = {});

/// The line of the bent shaft: position_mm, radial_displacement_um, slope_urad.
[[nodiscard]] std::string deflection_text(const spindle::Beam& beam, const DeflectionResult& result,
                                          std::string_view source, std::string_view model_text);

}  // namespace raceway::results
