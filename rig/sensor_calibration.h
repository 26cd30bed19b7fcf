#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/note.h"
#include "rig/torque_sensor.h"

namespace raceway::rig {

/// One reading of a calibration. Readings are in the order in which they were taken.
struct SensorReading {
  /// Reference torque, from weights on an arm or from a reference sensor; treated as exact [N m].
  double torque = unset;
  double signal = unset;  ///< [V]
  int line = 0;           ///< line in the file, for messages
};

inline constexpr int highest_sensor_degree = 3;

/// A test is significant if its p-value is below this limit.
inline constexpr double sensor_significance = 0.01;

/// Lack-of-fit test: compares the distances of the mean signals from the curve with the scatter of
/// repeated readings.
///
///   F = (Σ n_l (mean_l - V(M_l))² / (L - p)) / (Σ (V - mean_l)² / (N - L))
///
/// N readings V were taken at L torques: n_l readings with the mean signal mean_l at the torque
/// M_l. The curve V(M) has p coefficients. Source: [NISThandbook, 4.4.4.6].
struct LackOfFit {
  double statistic = unset;            ///< F; NaN if the readings allow no test
  double p_value = unset;              ///< [1]
  int degrees = 0, error_degrees = 0;  ///< L - p, N - L
  double repeatability = unset;        ///< scatter of repeated readings [V]; NaN without repeats
};

/// Mean signal at falling torque minus mean signal at rising torque, at each torque that was read
/// in both directions, except the ends of the range. Student's t test checks whether the mean of
/// these differences is zero.
struct Hysteresis {
  int torques = 0;            ///< number of torques read in both directions
  double mean = unset;        ///< mean difference [V]; NaN if `torques` is 0
  double largest = unset;     ///< largest difference with its sign [V]
  double largest_at = unset;  ///< torque of the largest difference [N m]
  double p_value = unset;     ///< p-value [1]; NaN below 3 torques
};

/// Result of the calibration of a sensor.
struct SensorCalibration {
  TorqueSensor sensor;
  int readings = 0, torques = 0, degrees_of_freedom = 0;
  double signal_range = unset;  ///< |V(highest) - V(lowest)|, the reference for relative errors [V]
  /// Standard deviation of `signal_range`, from the uncertainty of the coefficients [V].
  double range_std = unset;
  /// Largest distance of a mean signal at one torque from the best straight line [V].
  double off_line = unset;
  /// Largest distance of the mean signal at one torque from the curve [V].
  double off_curve = unset;
  /// p-value of the terms above the fitted degree, up to degree 3 [1]; NaN if no such term can be
  /// tested.
  double higher_terms_p_value = unset;
  LackOfFit lack_of_fit{};
  Hysteresis hysteresis{};
  /// p-value of a test for equal scatter at every torque [Koenker1981] [1]; NaN below 10 readings
  /// or without scatter.
  double even_scatter_p_value = unset;
  /// Scatter in the lower and upper half of the range of |M| [V]; NaN in the same cases as
  /// even_scatter_p_value.
  double scatter_low = unset, scatter_high = unset;
  std::vector<record::Note> notes{}, warnings{};

  [[nodiscard]] int degree() const { return static_cast<int>(sensor.coefficients.size()) - 1; }
  /// Returns the standard deviation of coefficient b_k [V/(N m)^k].
  [[nodiscard]] double std(int coefficient) const;
};

/// Fits the signal as a polynomial of the torque by least squares, with QR decomposition and a
/// scaled torque. If no degree is given, the lowest degree is used for which no higher term, up to
/// degree 3, is significant. If the scatter changes significantly along the range, the covariance
/// comes from HC3 of [MacKinnon1985], which is valid for such a change.
///
/// Throws std::invalid_argument for an invalid degree, for fewer than degree + 1 torques or degree
/// + 2 readings, and for a signal that does not depend on the torque or is not monotone.
/// Accuracy: 1e-10 relative to the certified values of the NIST data sets Pontius and Norris.
[[nodiscard]] SensorCalibration calibrate_sensor(std::span<const SensorReading> readings,
                                                 std::optional<int> degree = {});

}  // namespace raceway::rig
