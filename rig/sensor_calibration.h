#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/note.h"
#include "rig/torque_sensor.h"

namespace raceway::rig {

/// One reading of a calibration, in the order in which they were taken.
struct SensorReading {
  double torque = unset;  ///< by weights on an arm, or a reference sensor; taken as exact [N m]
  double signal = unset;  ///< [V]
  int line = 0;           ///< of the file, for messages
};

inline constexpr int highest_sensor_degree = 3;

/// Below this chance a test says that something is there.
inline constexpr double sensor_significance = 0.01;

/// Does the scatter of repeated readings explain how far their means are from the curve?
///
///   F = (Σ n_l (mean_l - V(M_l))² / (L - p)) / (Σ (V - mean_l)² / (N - L))
///
/// over N readings at L torques, with p coefficients. Source: [NISThandbook, 4.4.4.6].
struct LackOfFit {
  double statistic = unset;            ///< F; NaN without repeats
  double p_value = unset;              ///< [1]
  int degrees = 0, error_degrees = 0;  ///< L - p, N - L
  double repeatability = unset;        ///< standard deviation within repeats [V]
};

/// Readings with the torque falling less those with it rising, at the torques that have both; not
/// at the ends of the range, where both are one. Student's t of the mean over torques.
struct Hysteresis {
  int torques = 0;
  double mean = unset;        ///< [V]
  double largest = unset;     ///< with its sign [V]
  double largest_at = unset;  ///< [N m]
  double p_value = unset;     ///< [1]; NaN below 3 torques
};

/// Result of a calibration of a sensor.
struct SensorCalibration {
  TorqueSensor sensor;
  int readings = 0, torques = 0, degrees_of_freedom = 0;
  double signal_range = unset;  ///< |V(highest) - V(lowest)|, for shares [V]
  double range_std = unset;     ///< standard deviation of it: how sure the gain is [V]
  double off_line = unset;      ///< largest distance of a mean from the best straight line [V]
  double off_curve = unset;     ///< and from the curve [V]
  /// p-value that all further terms up to the third degree are scatter; NaN where none can be tried
  /// [1].
  double higher_terms_p_value = unset;
  LackOfFit lack_of_fit{};
  Hysteresis hysteresis{};
  /// p-value that the scatter is the same at every torque, after [Koenker1981]; NaN below 10
  /// readings [1].
  double even_scatter_p_value = unset;
  double scatter_low = unset, scatter_high = unset;  ///< of the lower and upper half [V]
  std::vector<record::Note> notes{}, warnings{};

  [[nodiscard]] int degree() const { return static_cast<int>(sensor.coefficients.size()) - 1; }
  /// Standard deviation of a coefficient.
  [[nodiscard]] double std(int coefficient) const;
};

/// Least squares of the signal over the torque, by QR on the scaled torque. Without a degree the
/// lowest beyond which no term up to the third is significant. Where the scatter changes along the
/// range the covariance is the one that holds for any scatter (HC3 of [MacKinnon1985]).
///
/// Throws std::invalid_argument: a degree that is none, one reference torque, too few torques or
/// readings for the degree, a signal that turns or does not follow the torque.
/// Accuracy: 1e-10 of the certified values of NIST's data sets Pontius and Norris.
[[nodiscard]] SensorCalibration calibrate_sensor(std::span<const SensorReading> readings,
                                                 std::optional<int> degree = {});

}  // namespace raceway::rig
