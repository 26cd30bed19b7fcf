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

/// Writes results for a shaft, modelled as a beam on its bearings, as CSV and JSON, with units in
/// the keys (docs/files.md). Values without an equilibrium are empty or null.
namespace raceway::results {

/// Modes at one speed, and the bearing sets that support the shaft at this speed.
struct ModesAtSpeed {
  double speed = unset;  ///< [rad/s]
  spindle::SetsAtSpeed sets;
  std::vector<spindle::Spring> springs;
  /// shaft under its constant loads, as DeflectionResult::unloaded
  std::optional<spindle::LoadedShaft> shaft = {};
  std::vector<std::string> roller_names = {};
  spindle::Modes modes;
  /// Frequencies of all bearings by name, per revolution of the shaft.
  std::vector<std::pair<std::string, bearing::BearingFrequencies>> rolling = {};
  double damping_ratio = unset;             ///< damping ratio as entered [1]
  std::optional<spindle::Orbit> nose = {};  ///< path of the nose under the requested unbalance
  [[nodiscard]] bool converged() const { return sets.converged() && modes.converged(); }
  /// Returns "converged", or the reason why sets or modes failed.
  [[nodiscard]] std::string status() const;
};

/// Intersection of a mode with an excitation proportional to the speed.
struct Crossing {
  std::string
      excitation;        ///< "1x", "2x", "front_1 cage", "front_1 outer race", "rear_1 inner race"
  std::size_t mode = 0;  ///< number of the mode in its direction; the lowest is 1
  spindle::Whirl whirl = spindle::Whirl::forward;
  double speed = unset, frequency = unset;  ///< [rad/s]
};

/// Returns the intersections of every mode with the excitations once and twice per revolution, and
/// with the frequencies of cage, outer and inner race of every bearing. The intersections are
/// interpolated linearly between the speeds and are in order of rising speed. Modes without a whirl
/// direction (standing) count alternately as backward and forward.
[[nodiscard]] std::vector<Crossing> crossings(const std::vector<ModesAtSpeed>& speeds);

/// Returns a Campbell diagram with the columns speed_rpm, mode, frequency_Hz, whirl, damping_ratio
/// (as entered, otherwise empty), front_force_N, rear_force_N, stiffness of each side and each
/// bearing, ring temperatures of warm sets, clearance and force of roller bearings, frequencies of
/// each bearing, the path of the nose if there is an unbalance, and status. The diagram has one row
/// for each mode, and one row without a mode for a speed without modes.
[[nodiscard]] std::string campbell_text(const bearing::Arrangement& arrangement,
                                        const std::vector<ModesAtSpeed>& speeds,
                                        std::string_view source, std::string_view model_text);

/// Returns the columns speed_rpm, mode, frequency_Hz, whirl, position_mm, y_amplitude, z_amplitude;
/// the largest amplitude is 1.
[[nodiscard]] std::string mode_shapes_text(const spindle::Beam& beam,
                                           const std::vector<ModesAtSpeed>& speeds,
                                           std::string_view source, std::string_view model_text);

[[nodiscard]] std::string campbell_json(const bearing::Arrangement& arrangement,
                                        const std::vector<ModesAtSpeed>& speeds,
                                        std::string_view source,
                                        const model::Findings& findings = {});

/// Result for the shaft under a force.
struct DeflectionResult {
  double speed = 0.0, force = unset, at = 0.0;  ///< [rad/s], [N], [m]
  bool axial = false;
  double axial_force = 0.0;  ///< in addition to a radial force, positive towards the tool [N]
  /// Moment in the plane of the radial force and at the same place [N m]. A positive moment turns
  /// the shaft like a positive force that acts further forward.
  double moment = 0.0;
  spindle::SetsAtSpeed sets;   ///< state without the force
  spindle::LoadedShaft shaft;  ///< state under the force; not run if the sets have no equilibrium
  /// State without the force, if a belt bends the shaft or rollers support it.
  std::optional<spindle::LoadedShaft> unloaded = {};
  std::vector<std::string> roller_names = {};
  double displacement = unset;  ///< displacement at the force, in the direction of the force [m]
  double nose = unset;          ///< displacement of the nose face in the direction of the force [m]
  double slope = unset;         ///< slope of the section at the nose [rad]
  double tangent = unset;       ///< displacement at the force with the stiffness before loading [m]
  [[nodiscard]] bool converged() const { return sets.converged() && shaft.report.converged(); }
  [[nodiscard]] std::string status() const;
  /// Returns the stiffness for a single force [N/m]; NaN for several loads.
  [[nodiscard]] double stiffness() const {
    return axial_force == 0.0 && moment == 0.0 ? force / displacement : unset;
  }
};

/// Returns "1000 N radial, -200 N axial, 50 N m".
[[nodiscard]] std::string load_words(const DeflectionResult& result);

[[nodiscard]] std::string deflection_json(const bearing::Arrangement& arrangement,
                                          const DeflectionResult& result, std::string_view source,
                                          const model::Findings& findings = {});

/// Returns the bending line of the shaft: position_mm, radial_displacement_um, slope_urad.
[[nodiscard]] std::string deflection_text(const spindle::Beam& beam, const DeflectionResult& result,
                                          std::string_view source, std::string_view model_text);

}  // namespace raceway::results
