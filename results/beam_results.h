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

/// Writes results for a shaft on its bearings, which is modelled as a beam, as CSV and JSON. The
/// names contain the units (docs/files.md). Without equilibrium, values are empty in CSV and null
/// in JSON.
namespace raceway::results {

/// Modes of the shaft at one speed, and the bearings that support the shaft at this speed.
struct ModesAtSpeed {
  double speed = unset;  ///< [rad/s]
  spindle::SetsAtSpeed sets;
  std::vector<spindle::Spring> springs;
  /// Equilibrium of the shaft under its constant loads, if a belt bends the shaft or roller
  /// bearings support it.
  std::optional<spindle::LoadedShaft> shaft = {};
  std::vector<std::string> roller_names = {};
  spindle::Modes modes;
  /// Damage frequencies of each bearing, with the name of the bearing, per revolution of the shaft.
  std::vector<std::pair<std::string, bearing::BearingFrequencies>> rolling = {};
  double damping_ratio = unset;             ///< damping ratio that the user gives [1]
  std::optional<spindle::Orbit> nose = {};  ///< orbit of the nose under the given unbalance
  [[nodiscard]] bool converged() const { return sets.converged() && modes.converged(); }
  /// Returns "converged", or the status of the bearing sets or modes without a solution, such as
  /// "not_held".
  [[nodiscard]] std::string status() const;
};

/// Intersection of a natural frequency with an excitation frequency, which is a multiple of the
/// speed.
struct Crossing {
  std::string
      excitation;        ///< "1x", "2x", "front_1 cage", "front_1 outer race", "rear_1 inner race"
  std::size_t mode = 0;  ///< number of the mode in its whirl direction; the lowest is 1
  spindle::Whirl whirl = spindle::Whirl::forward;
  double speed = unset, frequency = unset;  ///< [rad/s]
};

/// Returns the intersections of every mode with the excitations once and twice per revolution, and
/// with the cage, outer race and inner race frequencies of every bearing. The intersections are
/// interpolated linearly between the speeds, and are in ascending order of speed. Modes without
/// whirl (standing) are treated alternately as backward and forward.
[[nodiscard]] std::vector<Crossing> crossings(const std::vector<ModesAtSpeed>& speeds);

/// Returns a Campbell diagram as CSV with the columns speed_rpm, mode, frequency_Hz, whirl,
/// damping_ratio (empty if not given), front_force_N, rear_force_N, stiffness of the front side, of
/// the rear side and of each bearing, ring temperatures of warm bearing sets, clearance and force
/// of roller bearings, frequencies of each bearing, the orbit of the nose if an unbalance is given,
/// and status. Each mode at each speed has a row. A speed without modes has one row with empty mode
/// columns.
[[nodiscard]] std::string campbell_text(const bearing::Arrangement& arrangement,
                                        const std::vector<ModesAtSpeed>& speeds,
                                        std::string_view source, std::string_view model_text);

/// Returns the mode shapes as CSV with the columns speed_rpm, mode, frequency_Hz, whirl,
/// position_mm, y_amplitude and z_amplitude. The largest amplitude of each mode is 1.
[[nodiscard]] std::string mode_shapes_text(const spindle::Beam& beam,
                                           const std::vector<ModesAtSpeed>& speeds,
                                           std::string_view source, std::string_view model_text);

[[nodiscard]] std::string campbell_json(const bearing::Arrangement& arrangement,
                                        const std::vector<ModesAtSpeed>& speeds,
                                        std::string_view source,
                                        const model::Findings& findings = {});

/// Displacements and bearing loads of a shaft under a force.
struct DeflectionResult {
  double speed = 0.0, force = unset, at = 0.0;  ///< speed [rad/s], force [N] and its position [m]
  bool axial = false;
  double axial_force = 0.0;  ///< additional axial force, positive towards the tool [N]
  /// Moment in the plane of the radial force, at the position `at` [N m]. A positive moment turns
  /// the shaft like a positive force that acts further forward.
  double moment = 0.0;
  spindle::SetsAtSpeed sets;  ///< bearing sets without the force
  /// Equilibrium under the force; not run if the bearing sets have no equilibrium.
  spindle::LoadedShaft shaft;
  /// Equilibrium without the force, if a belt bends the shaft or roller bearings support it.
  std::optional<spindle::LoadedShaft> unloaded = {};
  std::vector<std::string> roller_names = {};
  double displacement = unset;  ///< displacement at the force, in its direction [m]
  double nose = unset;          ///< displacement of the nose face in the direction of the force [m]
  double slope = unset;         ///< slope of the bending line at the nose [rad]
  /// Displacement at the force, calculated with the bearing stiffness without the force [m].
  double tangent = unset;
  [[nodiscard]] bool converged() const { return sets.converged() && shaft.report.converged(); }
  [[nodiscard]] std::string status() const;
  /// Returns the force divided by the displacement at the force [N/m]; NaN if `axial_force` or
  /// `moment` is not zero.
  [[nodiscard]] double stiffness() const {
    return axial_force == 0.0 && moment == 0.0 ? force / displacement : unset;
  }
};

/// Returns the loads as text, such as "1000 N radial, -200 N axial, moment 50 N m".
[[nodiscard]] std::string load_words(const DeflectionResult& result);

[[nodiscard]] std::string deflection_json(const bearing::Arrangement& arrangement,
                                          const DeflectionResult& result, std::string_view source,
                                          const model::Findings& findings = {});

/// Returns the bending line of the shaft as CSV with the columns position_mm,
/// radial_displacement_um and slope_urad.
[[nodiscard]] std::string deflection_text(const spindle::Beam& beam, const DeflectionResult& result,
                                          std::string_view source, std::string_view model_text);

}  // namespace raceway::results
