#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/note.h"
#include "rig/torque_sensor.h"

namespace raceway::rig {

/// One reading of a calibration. The readings of a calibration must be in the order of measurement.
struct SensorReading {
  /// Reference torque, from weights on an arm or from a reference sensor; treated as exact [N m].
  double torque = unset;
  double signal = unset;  ///< [V]
  int line = 0;           ///< line in the file, for messages
};

inline constexpr int highest_sensor_degree = 3;

/// Limit of the p-value: a test result with a smaller p-value is significant.
inline constexpr double sensor_significance = 0.01;

/// Lack-of-fit test. The test compares the distances between mean signals and curve with the
/// scatter of repeated readings.
///
///   F = (Σ n_l (mean_l - V(M_l))² / (L - p)) / (Σ (V - mean_l)² / (N - L))
///
/// N readings V were taken at L torques: n_l readings with the mean signal mean_l at the torque
/// M_l. The curve V(M) has p coefficients. Source: [NISThandbook, 4.4.4.6].
struct LackOfFit {
  /// Test statistic F. NaN if the calibration has no repeated readings, if repeated readings do not
  /// scatter, or if L = p.
  double statistic = unset;
  double p_value = unset;              ///< [1]
  int degrees = 0, error_degrees = 0;  ///< degrees of freedom: L - p and N - L
  /// Scatter of repeated readings [V]. NaN if the calibration has no repeated readings.
  double repeatability = unset;
};

/// Hysteresis of the sensor: mean signal at falling torque minus mean signal at rising torque. The
/// difference is taken at each torque that was read in both directions, except at the ends of the
/// torque range. Student's t test checks whether the mean of the differences is zero.
struct Hysteresis {
  int torques = 0;            ///< number of torques at which the difference is taken
  double mean = unset;        ///< mean difference [V]; NaN if `torques` is 0
  double largest = unset;     ///< largest difference with its sign [V]
  double largest_at = unset;  ///< torque of the largest difference [N m]
  double p_value = unset;     ///< p-value of the t test [1]; NaN for fewer than 3 torques
};

/// Result of the calibration of a sensor.
struct SensorCalibration {
  TorqueSensor sensor;
  int readings = 0, torques = 0, degrees_of_freedom = 0;
  /// Change of the fitted signal over the torque range [V], the reference for relative errors.
  double signal_range = unset;
  /// Standard deviation of `signal_range`, from the uncertainty of the coefficients [V].
  double range_std = unset;
  /// Largest distance of the mean signal at one torque from the least-squares straight line [V].
  double off_line = unset;
  /// Largest distance of the mean signal at one torque from the fitted curve [V].
  double off_curve = unset;
  double off_curve_at = unset;  ///< torque at this distance [N m]
  /// p-value of a test for terms above the fitted degree, up to degree 3 [1]. NaN for degree 3, and
  /// if the readings are too few for a higher term.
  double higher_terms_p_value = unset;
  LackOfFit lack_of_fit{};
  Hysteresis hysteresis{};
  /// p-value of a test for equal scatter at every torque [Koenker1981] [1]. NaN for fewer than 10
  /// readings, or if the readings do not scatter about the curve.
  double even_scatter_p_value = unset;
  /// Scatter of the readings about the curve in the lower and upper half of the range of the torque
  /// magnitude |M| [V]. NaN for fewer than 10 readings, or if the readings do not scatter.
  double scatter_low = unset, scatter_high = unset;
  std::vector<record::Note> notes{}, warnings{};

  [[nodiscard]] int degree() const { return static_cast<int>(sensor.coefficients.size()) - 1; }
  /// Returns the standard deviation of the coefficient b_k [V/(N m)^k] with k = `coefficient`.
  [[nodiscard]] double std(int coefficient) const;
};

/// Fits the signal as a polynomial of the torque by least squares. If no degree is given, the
/// function uses the lowest degree above which no term up to degree 3 is significant. If the
/// scatter changes significantly along the range, the function uses the covariance estimate HC3 of
/// [MacKinnon1985], which is valid for unequal scatter.
///
/// Throws std::invalid_argument if the degree is invalid, if there are fewer than degree + 1
/// torques or degree + 2 readings, if the signal does not depend on the torque, or if the curve is
/// not monotone.
/// Accuracy: the coefficients agree with the certified values of the NIST data sets Pontius and
///           Norris to a relative error of 1e-10.
[[nodiscard]] SensorCalibration calibrate_sensor(std::span<const SensorReading> readings,
                                                 std::optional<int> degree = {});

}  // namespace raceway::rig
