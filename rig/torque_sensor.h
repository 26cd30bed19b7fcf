#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/note.h"
#include "record/units.h"

namespace raceway::rig {

/// Calibration of a torque sensor: its signal as a function of the torque [V].
///
///   V(M) = b0 + b1 M + b2 M² + b3 M³   from the lowest to the highest torque of the calibration,
///   beyond these torques: the tangent at the nearer end
///
/// Source:   definition. The inverse function gives the torque of a reading.
/// Domain:   V increases or decreases over the whole range, so that turning_torque() is empty.
/// Trap:     fit the signal as a function of the torque, not the reverse. Weights on an arm are
///           known much better than the signal, and the scatter of the signal would reduce the
///           slope of a fit of M over V.
struct TorqueSensor {
  Eigen::VectorXd coefficients{};  ///< b_k [V/(N m)^k]
  Eigen::MatrixXd covariance{};    ///< covariance matrix of the coefficients
  double scatter = unset;          ///< standard deviation of one reading of the signal [V]
  double lowest_torque = unset;    ///< lowest torque of the calibration [N m]
  double highest_torque = unset;   ///< highest torque of the calibration [N m]
  double lowest_signal = unset;    ///< lowest signal of the calibration [V]
  double highest_signal = unset;   ///< highest signal of the calibration [V]
  /// Signal without torque on the day of the record [V]; replaces V(0).
  std::optional<double> zero = {};
  /// Standard deviation of `zero` [V]; if empty, `scatter` of a single reading.
  std::optional<double> zero_std = {};
  std::string source = {};  ///< file of the calibration, for messages
};

/// Returns the torque from `lowest` to `highest` at which the slope of V(M) is zero or changes its
/// sign [N m]; empty if the signal determines the torque uniquely.
[[nodiscard]] std::optional<double> turning_torque(const Eigen::VectorXd& coefficients,
                                                   double lowest, double highest);

/// Returns the signal V(M) at a torque [V], with the zero of the calibration.
[[nodiscard]] double signal_at(const TorqueSensor& sensor, double torque);

/// Returns true if both sensors convert every signal to the same torque.
[[nodiscard]] bool same_torques(const TorqueSensor& a, const TorqueSensor& b);

/// A reading converted to a torque.
struct SensedTorque {
  double torque;  ///< M with V(M) = signal; with `zero`: V(M) - V(0) = signal - zero [N m]
  double std;     ///< standard deviation, sqrt(scatter²/V'(M)² + common²) [N m]
  /// Standard deviation of the error from the calibration and `TorqueSensor::zero` [N m]: sqrt(gᵀ C
  /// g + s²) / |V'|. C is the covariance of the coefficients b_k. Without `zero`, g = ∂V/∂b at M
  /// and s = 0. With `zero`, g is ∂V/∂b at M minus ∂V/∂b at 0, and s is the standard deviation of
  /// `zero`. All readings of a record share this error, and averaging does not reduce it.
  double common;
};

/// Returns the torque of a signal [V]. The standard deviations of the torque come from linear error
/// propagation. `signal_std` [V] replaces the scatter of one reading; NaN keeps the scatter.
[[nodiscard]] SensedTorque torque_of(const TorqueSensor& sensor, double signal,
                                     double signal_std = unset);

/// Readings of a record converted to torques.
struct SensedTorques {
  std::vector<double> torque{};  ///< one for each signal [N m]; NaN if the signal is NaN
  /// Standard deviation of each torque [N m]; empty if the calibration has no scatter.
  std::vector<double> std{};
  /// Notes on the errors of the torques and on signals outside the calibration.
  std::vector<record::Note> notes{};
};

/// Converts the signals of a record to torques. `deviations` has a standard deviation for each
/// signal [V], or is empty. `lines` are line numbers of the file, for notes.
[[nodiscard]] SensedTorques sensed_torques(const TorqueSensor& sensor,
                                           std::span<const double> signals,
                                           std::span<const double> deviations,
                                           std::span<const int> lines);

}  // namespace raceway::rig
