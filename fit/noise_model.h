#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "fit/observations.h"
#include "fit/row_order.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// Noise of the readings of one channel: its size, its growth with the reading and its correlation.
///
///   s_i² = (relative y_i (n_i/n_max)^p)² + (absolute a_i)² + (input b_i)²
///
/// s_i is the standard deviation of reading y_i, and n_i the value of the swept input, usually the
/// speed. For single rows, a_i is 1. For means over dwells, a_i comes from the scatter within the
/// dwell, and this part of the noise is independent of other readings. b_i is the change of reading
/// i when each input that scatters changes by its step (record::step_of()). All a_i are divided by
/// their RMS, and so are all b_i. The class Whitening describes the correlation of the noise. If
/// standard deviations are declared, they give the relative sizes of all s_i. The noise is
/// estimated from the residuals of a saturated regression (Saturation). The misfit of a physical
/// model is never used, because missing physics would then appear as noise.
struct NoiseModel {
  /// Proportional part of the standard deviation, divided by the reading, at the largest value
  /// n_max of the swept input [1].
  double relative = 0.0;
  double growth = 0.0;             ///< p: exponent of the swept input [1]
  const Channel* swept = nullptr;  ///< n: swept input; null if none is swept over a wide range
  double largest_swept = unset;    ///< n_max: largest value of the swept input [SI]
  double absolute = 0.0;           ///< RMS of the noise that does not grow with the reading [SI]
  double input = 0.0;              ///< RMS of the noise from the scatter of inputs [SI]
  double correlation = 0.0;  ///< φ: correlation of the noise at a distance of `median_step` [1]
  double run_share = 0.0;    ///< share of the noise variance from an offset of each run [1]
  /// Size of run offsets that are equal for all readings of a run [SI]. The variance of the offsets
  /// is `run_share` times the square of this size. The size is 0 if the offset of a reading is
  /// proportional to its standard deviation.
  double run_unit = 0.0;
  double state_share = 0.0;           ///< share of the noise variance from dwell offsets [1]
  double degrees_of_freedom = unset;  ///< degrees of freedom of the estimated variance
  Whitening whitening{};
  /// Whitenings with other noise parameters that the readings also allow. A verdict must be valid
  /// with each of them.
  std::vector<Whitening> allowed{};
  /// True if the data cannot show offsets of runs, for example because a setting changes whenever
  /// the run changes. `run_share` is then at least 0.5 (1 - `state_share`).
  bool unknown_runs = false;
  /// True if `run_share` describes blocks of rows that are not declared as runs
  /// (RowOrder::new_block).
  bool undeclared_blocks = false;
  bool as_declared = false;  ///< true: the declared standard deviations agree with the estimate
  /// Indices of the outliers. They have a reduced weight, but the fit uses all of them.
  std::vector<std::size_t> outliers{};
  /// Factor by which the standard deviations of each joined record are multiplied [1]; empty if all
  /// records have the same scatter.
  std::vector<double> records{};
  double rms = unset;          ///< RMS of the standard deviations s_i [SI]
  double median_step = unset;  ///< median time between readings; `correlation` refers to it [s]
  /// F statistic and p-value of the test whether repeated readings scatter more than this noise
  /// [1]; NaN below 8 degrees of freedom.
  double repeats_statistic = unset, repeats_p_value = unset;

  /// Multiplies all standard deviations by a factor.
  void scale(double factor);
  [[nodiscard]] bool has_memory() const {
    return correlation > 0.0 || run_share > 0.0 || state_share > 0.0;
  }
  /// Returns the standard deviation of the run offsets [SI], as RMS over the readings.
  [[nodiscard]] double run_offset() const;
  /// Returns the factor (n/n_max)^p of a row [1]; 1 if the noise does not grow with the swept
  /// input.
  [[nodiscard]] double growth_at(const Record& record, std::size_t row) const;
};

/// Parts of the noise model. A part that is set to false is not used. To see the influence of a
/// part, compare the results with and without the part.
struct NoiseOptions {
  bool correlation = true;
  bool runs = true;
  bool absolute = true;
  bool outliers = true;
  bool growth = true;
  bool alternatives = true;  ///< false: NoiseModel::allowed is not searched and stays empty
};

/// Readings of one channel, prepared for the estimate of their noise.
struct ChannelReadings {
  Eigen::VectorXd measured{};  ///< readings [SI]
  /// Declared standard deviations [SI]; empty unless every reading has one.
  Eigen::VectorXd std{};
  bool known = false;  ///< true if `std` is treated as exact (Column::known)
  /// Change of each reading when each input that scatters changes by its step (record::step_of()):
  /// root of the sum of squares over these inputs [SI]; empty if no input scatters.
  Eigen::VectorXd slope{};
  /// Standard deviation of each mean over a dwell, up to a common factor [1]; empty if rows are not
  /// means.
  Eigen::VectorXd within{};
  /// Swept input and its value at each reading [SI, > 0]; null and empty if no input is swept over
  /// a wide range.
  const Channel* swept_by = nullptr;
  Eigen::VectorXd swept{};
  /// For each setting with 2 to 24 levels, the index of the level at each reading.
  std::vector<std::vector<std::size_t>> levels{};
  RowOrder order{};
  /// Index of the joined record of each reading; empty without joined records.
  std::vector<std::size_t> part{};
  std::vector<std::vector<std::size_t>> repeats{};  ///< groups of readings with equal inputs
};

[[nodiscard]] ChannelReadings readings_of(const Record& record, const Observations& observed,
                                          std::size_t channel);

/// Estimates the noise of one channel by restricted maximum likelihood. `columns` are the terms of
/// the saturated regression at the readings [SI], with full rank. `size` is a typical size of each
/// reading [SI, > 0]. An outlier is a reading whose residual is at least as improbable as a normal
/// variable beyond 3.5 standard deviations. Its weight falls with the size of the residual, and it
/// adds no degree of freedom. The function tests for growth of the scatter with the swept input
/// before it calls a reading an outlier. If more of these readings lie at one level of a setting
/// than chance explains, they are not outliers.
[[nodiscard]] NoiseModel estimate_noise_model(const ChannelReadings& readings,
                                              const Eigen::MatrixXd& columns,
                                              const Eigen::VectorXd& size,
                                              const NoiseOptions& options = {});

/// Returns the whitening with this noise for other readings of the channel. `size` is a typical
/// size of each reading [SI].
[[nodiscard]] Whitening whitening_of(const NoiseModel& noise, const ChannelReadings& readings,
                                     const Eigen::VectorXd& size);

/// Returns the part of an RMS error that the noise does not explain: sqrt(error² - noise²), or 0 if
/// the error is smaller than the noise.
[[nodiscard]] double beyond_noise(double error, double noise);

/// Adds the error of the model to the noise, as an independent scatter with the standard deviation
/// `error` [SI] in every reading.
void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error);

/// Returns the noise of independent readings with the known standard deviations
/// ChannelReadings::std. Use this function if each reading is the result of a regression over many
/// samples. The regression then determines the scatter well.
[[nodiscard]] NoiseModel known_noise_model(const ChannelReadings& readings);

}  // namespace raceway::fit
