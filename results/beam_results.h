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

/// Writes results for a shaft on its bearings as CSV and JSON. The shaft is modelled as a beam. The
/// names contain the units (docs/files.md). Values that need an equilibrium are empty in CSV and
/// null in JSON if the solver found none.
namespace raceway::results {

/// Modes of the shaft at one speed, and the bearings that support the shaft at this speed.
struct ModesAtSpeed {
  double speed = unset;  ///< [rad/s]
  spindle::SetsAtSpeed sets;
  std::vector<spindle::Spring> springs;
  /// Equilibrium of the shaft under its constant loads; calculated only if a belt bends the shaft
  /// or roller bearings support the shaft.
  std::optional<spindle::LoadedShaft> shaft = {};
  std::vector<std::string> roller_names = {};
  spindle::Modes modes;
  /// Name of each bearing, and its damage frequencies divided by the rotational frequency of the
  /// shaft [1].
  std::vector<std::pair<std::string, bearing::BearingFrequencies>> rolling = {};
  double damping_ratio = unset;             ///< damping ratio that the user gives [1]
  std::optional<spindle::Orbit> nose = {};  ///< orbit of the nose under the unbalance
  [[nodiscard]] bool converged() const { return sets.converged() && modes.converged(); }
  /// Returns "converged", or the status of the calculation that failed (bearing sets or modes),
  /// such as "not_held" for a shaft that springs and supports do not hold.
  [[nodiscard]] std::string status() const;
};

/// Intersection of a natural frequency with an excitation frequency. The excitation frequency is a
/// multiple of the speed.
struct Crossing {
  /// Name of the excitation: "1x", "2x", "front_1 cage", "front_1 outer race", "rear_1 inner race".
  std::string excitation;
  std::size_t mode = 0;  ///< number of the mode, counted from 1 for each whirl direction
  spindle::Whirl whirl = spindle::Whirl::forward;
  double speed = unset, frequency = unset;  ///< [rad/s]
};

/// Returns the speeds at which the frequency of a mode equals an excitation frequency: once or
/// twice the speed of the shaft, or the cage, outer race or inner race frequency of a bearing. The
/// intersections are interpolated linearly between the speeds of `speeds`, and are in ascending
/// order of speed. Modes without a whirl direction are numbered alternately as backward and as
/// forward modes.
[[nodiscard]] std::vector<Crossing> crossings(const std::vector<ModesAtSpeed>& speeds);

/// Returns a Campbell diagram as CSV with one row for each mode at each speed. The columns are
/// speed_rpm, mode, frequency_Hz, whirl, damping_ratio (empty if not given), columns for the
/// forces, stiffnesses and damage frequencies of the bearings, and status. If the ring temperatures
/// were calculated, the table has columns for these temperatures. For each roller bearing, the
/// table has columns for clearance, force and stiffness. If an unbalance is given, the table has
/// columns for the orbit of the nose. A speed without modes has one row in which the columns of the
/// mode are empty.
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

/// Displacements and bearing loads of a shaft under a force at one place.
struct DeflectionResult {
  /// Speed [rad/s], force [N], and distance of the force from the nose face [m].
  double speed = 0.0, force = unset, at = 0.0;
  bool axial = false;
  double axial_force = 0.0;  ///< additional axial force, positive towards the tool [N]
  /// Moment in the plane of the radial force, at the position `at` [N m]. A positive moment turns
  /// the shaft in the same direction as a positive radial force between this position and the tool.
  double moment = 0.0;
  spindle::SetsAtSpeed sets;  ///< bearing sets without the force
  /// Equilibrium under the force; not computed if the bearing sets have no equilibrium.
  spindle::LoadedShaft shaft;
  /// Equilibrium without the force; empty unless a belt bends the shaft or roller bearings support
  /// the shaft.
  std::optional<spindle::LoadedShaft> unloaded = {};
  std::vector<std::string> roller_names = {};
  /// Displacement at the position of the force, in the direction of the force [m].
  double displacement = unset;
  double nose = unset;   ///< displacement of the nose face in the direction of the force [m]
  double slope = unset;  ///< slope of the bending line at the nose [rad]
  /// Displacement at the position of the force if the bearings had constant stiffness, equal to
  /// their stiffness without the force [m].
  double tangent = unset;
  [[nodiscard]] bool converged() const { return sets.converged() && shaft.report.converged(); }
  [[nodiscard]] std::string status() const;
  /// Returns the force divided by `displacement` [N/m]; NaN if `axial_force` or `moment` is not
  /// zero.
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
