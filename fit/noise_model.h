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
/// s_i is the standard deviation of reading y_i. The input n is the swept input. In general, a_i is
/// 1. The number b_i is the change of reading i when an input changes by the width of a level.
/// Both a and b are divided by their rms. The correlation is described in Whitening. For means over
/// dwells, a_i comes from the scatter within the dwell, and this part of the noise is independent
/// of other readings. Declared standard deviations replace the whole sum. The noise is estimated
/// from the residuals of a saturated regression. The misfit of a physical model is never used,
/// because missing physics would then appear as noise.
struct NoiseModel {
  /// Standard deviation relative to the reading, at the largest value of the swept input [1].
  double relative = 0.0;
  double growth = 0.0;             ///< p: exponent of the growth with the swept input [1]
  const Channel* swept = nullptr;  ///< n; null if no input is swept over a wide range
  double largest_swept = unset;    ///< n_max [SI]
  double absolute = 0.0;           ///< rms of the part that does not grow with the reading [SI]
  double input = 0.0;              ///< rms of the part from scatter of an input [SI]
  double correlation = 0.0;        ///< φ of neighbours in time, at the median time step [1]
  double run_share = 0.0;  ///< share of the variance that is common to the rows of a run [1]
  /// Size of offsets that all readings of a run share [SI]. The variance of the offsets is
  /// `run_share` times the square of this size. The size is 0 if the offset of a reading is
  /// proportional to the standard deviation of this reading.
  double run_unit = 0.0;
  double state_share = 0.0;  ///< share of the variance that is common to the pieces of a dwell [1]
  double degrees_of_freedom = unset;  ///< degrees of freedom of the variance
  Whitening whitening{};
  /// Other shapes of the noise that the readings allow. A verdict must be valid for each of these
  /// shapes.
  std::vector<Whitening> allowed{};
  /// True if the data cannot show offsets of runs, because a setting also changes with every change
  /// of run.
  bool unknown_runs = false;
  /// True: `run_share` describes blocks that are not declared as runs.
  bool undeclared_blocks = false;
  bool as_declared = false;  ///< true: the declared standard deviations agree with the estimate
  std::vector<std::size_t> outliers{};  ///< readings with reduced weight; none is left out
  /// Factor on the standard deviations of each joined record [1]; empty if all records have the
  /// same scatter.
  std::vector<double> records{};
  double rms = unset;          ///< rms over the readings [SI]
  double median_step = unset;  ///< time step to which the correlation refers [s]
  /// F statistic and p-value of the repeats relative to the saturated regression; NaN below 8
  /// degrees of freedom.
  double repeats_statistic = unset, repeats_p_value = unset;

  /// Multiplies all parts of the noise by a factor.
  void scale(double factor);
  [[nodiscard]] bool has_memory() const {
    return correlation > 0.0 || run_share > 0.0 || state_share > 0.0;
  }
  /// Returns the standard deviation of the run offsets, rms over the readings [SI].
  [[nodiscard]] double run_offset() const;
  /// Returns the growth factor (n/n_max)^p of a row [1].
  [[nodiscard]] double growth_at(const Record& record, std::size_t row) const;
};

/// Parts of the noise model that can be switched off, to study their influence.
struct NoiseOptions {
  bool correlation = true;
  bool runs = true;
  bool absolute = true;
  bool outliers = true;
  bool growth = true;
};

/// Readings of one channel, prepared for the estimate of their noise.
struct ChannelReadings {
  Eigen::VectorXd measured{};  ///< SI
  /// Declared standard deviations [SI]; empty unless every reading has one.
  Eigen::VectorXd std{};
  bool known = false;  ///< true if `std` is practically exact
  /// Change of each reading when a scattering input changes by the width of a level [SI]; empty if
  /// no input scatters.
  Eigen::VectorXd slope{};
  /// Standard deviation of means from the scatter within them, up to a factor; empty for rows that
  /// are not means.
  Eigen::VectorXd within{};
  /// Swept input of the record [SI, > 0]; null and empty if no input is swept over a wide range.
  const Channel* swept_by = nullptr;
  Eigen::VectorXd swept{};
  /// Level of each reading, for each setting with few levels.
  std::vector<std::vector<std::size_t>> levels{};
  RowOrder order{};
  std::vector<std::size_t> part{};                  ///< joined record of each reading; may be empty
  std::vector<std::vector<std::size_t>> repeats{};  ///< groups of readings at one point
};

[[nodiscard]] ChannelReadings readings_of(const Record& record, const Observations& observed,
                                          std::size_t channel);

/// Estimates the noise from the saturated regression `columns` (SI, full rank) by restricted
/// maximum likelihood. `size` is a typical size of each reading [SI, > 0]; it affects only the
/// first weights. Outliers get a weight that falls with their distance. An outlier is a reading at
/// least as improbable as a reading beyond 3.5 standard deviations of a known normal distribution.
/// Outliers add no degree of freedom. The function tests for growth of the scatter with the swept
/// input before it calls a reading an outlier. Readings that gather at one level of a setting are
/// not outliers.
[[nodiscard]] NoiseModel estimate_noise_model(const ChannelReadings& readings,
                                              const Eigen::MatrixXd& columns,
                                              const Eigen::VectorXd& size,
                                              const NoiseOptions& options = {});

/// Returns the whitening of this noise for other readings of the channel. `size` is a typical size
/// of each reading [SI].
[[nodiscard]] Whitening whitening_of(const NoiseModel& noise, const ChannelReadings& readings,
                                     const Eigen::VectorXd& size);

/// Returns the error in excess of the noise, from two rms values: sqrt(error² - noise²), or 0 if
/// the error is smaller.
[[nodiscard]] double beyond_noise(double error, double noise);

/// Adds the declared error of the model to the noise as independent scatter. `error` [SI] applies
/// to every reading.
void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error);

/// Returns the noise of independent readings with the known standard deviations
/// ChannelReadings::std. Use this function for readings that come from a regression over many more
/// samples than there are readings, because the regression then determines the scatter well.
[[nodiscard]] NoiseModel known_noise_model(const ChannelReadings& readings);

}  // namespace raceway::fit
