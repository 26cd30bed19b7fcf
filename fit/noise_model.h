#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "fit/observations.h"
#include "fit/row_order.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// Noise of the readings of one channel: size, growth with the reading, and correlation.
///
///   s_i² = (relative y_i (n_i/n_max)^p)² + (absolute a_i)² + (input b_i)²
///
/// s_i is the standard deviation of reading y_i, and n_i the value of the swept input. The swept
/// input is the first setting that varies by more than a factor of 1.5, usually the speed. For
/// single rows, a_i is 1. For means over dwells, a_i comes from the scatter within the dwell. b_i
/// is the change of reading i if an input that scatters changes by its step (record::step_of()).
/// For several inputs, b_i is the root of the sum of the squared changes. The a_i are scaled so
/// that their RMS is 1, and so are the b_i. The scatter within dwells and the scatter of inputs are
/// not correlated between readings. The class Whitening describes the correlation of the noise.
/// Declared standard deviations, if there are any, give the relative sizes of all s_i. The noise is
/// estimated from the residuals of a saturated regression (Saturation). The misfit of a physical
/// model is never used, because a missing effect would then appear as noise.
struct NoiseModel {
  /// Proportional part of the standard deviation, divided by the reading, at the largest value
  /// n_max of the swept input [1].
  double relative = 0.0;
  double growth = 0.0;             ///< p, exponent of n/n_max [1]
  const Channel* swept = nullptr;  ///< n: swept input; null if no setting varies enough
  double largest_swept = unset;    ///< n_max: largest value of the swept input [SI]
  /// RMS of the part of the noise that does not grow with the reading [SI].
  double absolute = 0.0;
  /// RMS of the part of the noise that comes from the scatter of inputs [SI].
  double input = 0.0;
  /// Correlation φ between the noise at two times that differ by `median_step` [1].
  double correlation = 0.0;
  /// Share of the noise variance that comes from run offsets, the errors common to all readings of
  /// a run [1].
  double run_share = 0.0;
  /// u: scale of run offsets that are equal for all readings of a run [SI]; see Whitening. The
  /// variance of these offsets is `run_share` u². u is 0 if the run offset of each reading is
  /// proportional to the standard deviation of this reading.
  double run_unit = 0.0;
  /// Share of the noise variance that comes from dwell offsets, the errors common to all readings
  /// of a dwell [1].
  double state_share = 0.0;
  double degrees_of_freedom = unset;  ///< degrees of freedom of the estimated variance
  Whitening whitening{};
  /// Whitenings with other noise parameters that agree with the readings nearly as well. A
  /// diagnosis repeats its tests with these whitenings, so that a verdict does not depend on the
  /// choice.
  std::vector<Whitening> allowed{};
  /// True if the data cannot show offsets of runs, for example because a setting changes whenever
  /// the run changes. `run_share` is then at least 0.5 (1 - `state_share`).
  bool unknown_runs = false;
  /// True if `run_share` describes blocks of rows that are not declared as runs
  /// (RowOrder::new_block).
  bool undeclared_blocks = false;
  bool as_declared = false;  ///< true: the declared standard deviations agree with the estimate
  /// Indices of the outliers. The fit uses outliers with a reduced weight.
  std::vector<std::size_t> outliers{};
  /// One factor for each joined record, which multiplies the standard deviations of the readings of
  /// this record [1]. Empty if all records have the same scatter.
  std::vector<double> records{};
  double rms = unset;          ///< RMS of the standard deviations s_i [SI]
  double median_step = unset;  ///< median time between readings; `correlation` refers to it [s]
  /// F statistic and p-value of a two-sided test that compares the variance of readings at equal
  /// inputs with the noise variance [1]. NaN if the scatter at equal inputs has fewer than 8
  /// degrees of freedom.
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

/// Parts of the noise model. The estimate omits each part that is set to false.
struct NoiseOptions {
  bool correlation = true;
  bool runs = true;
  bool absolute = true;
  bool outliers = true;
  bool growth = true;
  bool alternatives = true;  ///< true: the function also determines NoiseModel::allowed
};

/// Readings of one channel, prepared for the estimate of their noise.
struct ChannelReadings {
  Eigen::VectorXd measured{};  ///< readings [SI]
  /// Declared standard deviations [SI]; empty unless every reading has one.
  Eigen::VectorXd std{};
  bool known = false;  ///< true if `std` is treated as exact (Column::known)
  /// b_i of NoiseModel before scaling: effect of the scatter of inputs on each reading [SI]. Each
  /// input that scatters changes by its step (record::step_of()), and b_i is the root of the sum of
  /// the squared changes of reading i. Empty if no input scatters.
  Eigen::VectorXd slope{};
  /// a_i of NoiseModel: relative sizes of the standard deviations if the rows are means over dwells
  /// [1]; otherwise empty.
  Eigen::VectorXd within{};
  /// Swept input and its value at each reading [SI, > 0]; null and empty if no setting varies
  /// enough (see NoiseModel).
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

/// Estimates the noise of one channel by restricted maximum likelihood. `columns` is a matrix of
/// full rank with the terms of the saturated regression at the readings [SI]. `size` is a typical
/// size of each reading [SI, > 0].
///
/// An outlier is a reading whose residual is at most as probable as a normal variable beyond 3.5
/// standard deviations. The weight of an outlier decreases with the size of its residual. Outliers
/// do not add degrees of freedom. If such improbable readings gather at one level of a setting,
/// they are not treated as outliers, because this level probably has a larger scatter.
[[nodiscard]] NoiseModel estimate_noise_model(const ChannelReadings& readings,
                                              const Eigen::MatrixXd& columns,
                                              const Eigen::VectorXd& size,
                                              const NoiseOptions& options = {});

/// Returns the whitening of `readings` for the noise model `noise`, estimated from other readings
/// of the same channel. NoiseModel::input is not used. `size` is a typical size of each reading
/// [SI].
[[nodiscard]] Whitening whitening_of(const NoiseModel& noise, const ChannelReadings& readings,
                                     const Eigen::VectorXd& size);

/// Returns the part of an RMS error that the noise does not explain: sqrt(error² - noise²), or 0 if
/// the error is smaller than the noise.
[[nodiscard]] double beyond_noise(double error, double noise);

/// Adds the error of the model to the noise: an independent scatter with the standard deviation
/// `error` [SI] in every reading.
void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error);

/// Returns the noise of independent readings with the standard deviations ChannelReadings::std,
/// which are treated as exact. Use this function if each reading is the result of a regression over
/// many samples.
[[nodiscard]] NoiseModel known_noise_model(const ChannelReadings& readings);

}  // namespace raceway::fit
