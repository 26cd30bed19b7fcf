#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/note.h"
#include "record/units.h"

namespace raceway::rig {

/// Signal of a torque sensor at a torque, by its calibration [V].
///
///   V(M) = b0 + b1 M + b2 M² + b3 M³   from the lowest to the highest torque of the calibration,
///   beyond them the tangent at that end
///
/// Source:   definition; the inverse is the torque of a reading.
/// Domain:   V rises, or falls, throughout the range: turning_torque() has no value.
/// Trap:     the signal as a function of the torque and not the reverse: weights on an arm are
///           known much better than the signal, whose scatter would flatten a fit of M over V.
struct TorqueSensor {
  Eigen::VectorXd coefficients{};       ///< b_k [V/(N m)^k]
  Eigen::MatrixXd covariance{};         ///< of them
  double scatter = unset;               ///< standard deviation of one reading of the signal [V]
  double lowest_torque = unset;         ///< of the calibration [N m]
  double highest_torque = unset;        ///< [N m]
  double lowest_signal = unset;         ///< that was seen in it [V]
  double highest_signal = unset;        ///< [V]
  std::optional<double> zero = {};      ///< signal without torque on the day, in place of V(0) [V]
  std::optional<double> zero_std = {};  ///< of it [V]; `scatter` if not given (one reading)
  std::string source = {};              ///< where the calibration is from, for messages
};

/// The torque at which the slope of V(M) is zero or has changed its sign within the range [N m];
/// nothing where every signal belongs to one torque.
[[nodiscard]] std::optional<double> turning_torque(const Eigen::VectorXd& coefficients,
                                                   double lowest, double highest);

/// The signal at a torque [V], whatever was seen at zero.
[[nodiscard]] double signal_at(const TorqueSensor& sensor, double torque);

/// Returns true if both sensors convert every signal to the same torque.
[[nodiscard]] bool same_torques(const TorqueSensor& a, const TorqueSensor& b);

/// A reading as a torque.
struct SensedTorque {
  double torque;  ///< M with V(M) = V, or V(M) - V(0) = V - zero [N m]
  double std;     ///< sqrt(scatter²/V'(M)² + common²) [N m]
  /// Error from the calibration and the zero of the day: gᵀ C g with g = -∂V/∂b / V'. It is equal
  /// in all readings of a record, and averaging does not reduce it [N m].
  double common;
};

/// Accuracy: rounding; the standard deviations are linearised.
/// `signal_std` [V] takes the place of the scatter of one reading; NaN: not known.
[[nodiscard]] SensedTorque torque_of(const TorqueSensor& sensor, double signal,
                                     double signal_std = unset);

/// Readings of a record as torques.
struct SensedTorques {
  std::vector<double> torque{};       ///< [N m]; NaN where nothing was read
  std::vector<double> std{};          ///< [N m]; empty where the calibration knows of no scatter
  std::vector<record::Note> notes{};  ///< on their errors, and on signals that no weight has made
};

/// `deviations` has one for each signal [V] or none; `lines` of the file, for notes.
[[nodiscard]] SensedTorques sensed_torques(const TorqueSensor& sensor,
                                           std::span<const double> signals,
                                           std::span<const double> deviations,
                                           std::span<const int> lines);

}  // namespace raceway::rig
