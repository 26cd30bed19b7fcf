#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/note.h"
#include "record/units.h"

namespace raceway::rig {

/// Calibration of a torque sensor: signal V as a function of the torque M [V].
///
///   V(M) = b0 + b1 M + b2 M² + b3 M³   from the lowest to the highest torque of the calibration,
///   beyond these torques: the tangent at the nearer end
///
/// Source:   definition. The inverse of V(M) converts a signal to a torque.
/// Domain:   V(M) must either rise or fall over the whole range of the calibration.
///           turning_torque() checks this.
/// Trap:     fit the signal as a function of the torque. If the torque is fitted as a function of
///           the signal, the scatter of the signal reduces the slope.
struct TorqueSensor {
  Eigen::VectorXd coefficients{};  ///< b_k [V/(N m)^k]
  Eigen::MatrixXd covariance{};    ///< covariance matrix of the coefficients
  double scatter = unset;          ///< standard deviation of one reading of the signal [V]
  double lowest_torque = unset;    ///< lowest torque of the calibration [N m]
  double highest_torque = unset;   ///< highest torque of the calibration [N m]
  double lowest_signal = unset;    ///< lowest signal of the calibration [V]
  double highest_signal = unset;   ///< highest signal of the calibration [V]
  /// Signal without torque on the day of the record [V]. If `zero` is given, the torque M is the
  /// solution of V(M) - V(0) = signal - zero.
  std::optional<double> zero = {};
  /// Standard deviation of `zero` [V]. If `zero_std` is empty, `scatter` is used.
  std::optional<double> zero_std = {};
  std::string source = {};  ///< file of the calibration, for messages
};

/// Returns the torque between `lowest` and `highest` at which V(M) stops rising or falling, so that
/// its slope is zero [N m]. Near this torque, a signal does not determine the torque uniquely.
/// Returns no value if V(M) rises or falls over the whole range.
[[nodiscard]] std::optional<double> turning_torque(const Eigen::VectorXd& coefficients,
                                                   double lowest, double highest);

/// Returns the signal V(M) at a torque [V]. Ignores TorqueSensor::zero.
[[nodiscard]] double signal_at(const TorqueSensor& sensor, double torque);

/// Returns true if both sensors convert every signal to the same torque.
[[nodiscard]] bool same_torques(const TorqueSensor& a, const TorqueSensor& b);

/// A reading converted to a torque.
struct SensedTorque {
  /// Torque M, the solution of V(M) = signal [N m]. If TorqueSensor::zero is given, M is the
  /// solution of V(M) - V(0) = signal - zero.
  double torque;
  /// Standard deviation of the torque, sqrt(scatter²/V'(M)² + common²) [N m]. V'(M) is the slope of
  /// the calibration curve.
  double std;
  /// Part of `std` that comes from the calibration and from TorqueSensor::zero [N m]. All readings
  /// of a record share this error, so averaging does not reduce the error.
  double common;
};

/// Converts a signal [V] to a torque. The standard deviations of the torque come from linear error
/// propagation. `signal_std` [V] replaces TorqueSensor::scatter, the standard deviation of one
/// reading. If `signal_std` is NaN, TorqueSensor::scatter is used.
[[nodiscard]] SensedTorque torque_of(const TorqueSensor& sensor, double signal,
                                     double signal_std = unset);

/// Readings of a record converted to torques.
struct SensedTorques {
  std::vector<double> torque{};  ///< one torque for each signal [N m]; NaN if the signal is NaN
  /// Standard deviation of each torque [N m]; empty if the calibration has no scatter.
  std::vector<double> std{};
  /// Notes on the errors of the torques, and on signals outside the range of the calibration.
  std::vector<record::Note> notes{};
};

/// Converts the signals of a record to torques. `deviations` has the standard deviation of each
/// signal [V]. If `deviations` is empty, the scatter of the calibration is used. `lines` are line
/// numbers of the file, for notes.
[[nodiscard]] SensedTorques sensed_torques(const TorqueSensor& sensor,
                                           std::span<const double> signals,
                                           std::span<const double> deviations,
                                           std::span<const int> lines);

}  // namespace raceway::rig
