#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "fit/observations.h"
#include "fit/row_order.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// Noise of the readings of one channel: its size, its growth with the reading, its correlation.
///
///   s_i² = (relative y_i (n_i/n_max)^p)² + (absolute a_i)² + (input b_i)²
///
/// with the input n that records sweep, a_i = 1 and b_i the change of the reading as an input
/// changes by the width of a level, both over their rms; and the correlation of Whitening. For
/// means over dwells, a_i comes from the scatter within a dwell, independent of its neighbours.
/// Declared standard deviations take the place of the whole sum. The noise is estimated from the
/// residuals of a saturated regression, never from the misfit of a physical model, which would
/// count missing physics as noise.
struct NoiseModel {
  /// Standard deviation in proportion to the reading, at the largest of the swept input [1].
  double relative = 0.0;
  double growth = 0.0;             ///< p: power of the swept input with which it grows [1]
  const Channel* swept = nullptr;  ///< n; null where nothing is swept widely
  double largest_swept = unset;    ///< n_max [SI]
  double absolute = 0.0;           ///< rms of the part that does not grow with it [SI]
  double input = 0.0;              ///< rms of the part that comes from scatter of an input [SI]
  double correlation = 0.0;        ///< φ of neighbours in time, at the median step [1]
  double run_share = 0.0;          ///< of the variance, common to the rows of a run [1]
  /// Size of offsets that all readings of a run share [SI]: their variance is `run_share` times its
  /// square. 0 where an offset goes with the standard deviation of each reading.
  double run_unit = 0.0;
  double state_share = 0.0;           ///< of the variance, common to the pieces of a dwell [1]
  double degrees_of_freedom = unset;  ///< of the variance
  Whitening whitening{};
  /// Other shapes of the same noise that the readings allow: a verdict has to hold under each.
  std::vector<Whitening> allowed{};
  /// Nothing tells how much runs differ: runs and levels of the plan coincide.
  bool unknown_runs = false;
  bool undeclared_blocks = false;       ///< `run_share` is for blocks not declared as runs
  bool as_declared = false;             ///< the declared standard deviations are what is found
  std::vector<std::size_t> outliers{};  ///< readings counted with less weight, none left out
  /// Factor on the standard deviations of each of several joined records [1]; empty where they
  /// scatter alike.
  std::vector<double> records{};
  double rms = unset;          ///< over the readings [SI]
  double median_step = unset;  ///< of time, to which the correlation belongs [s]
  /// Repeats against the saturated regression: F and its p; NaN below 8 degrees of freedom.
  double repeats_statistic = unset, repeats_p_value = unset;

  /// All of it, larger by a factor.
  void scale(double factor);
  [[nodiscard]] bool has_memory() const {
    return correlation > 0.0 || run_share > 0.0 || state_share > 0.0;
  }
  /// Standard deviation of the offsets of runs, rms over the readings [SI].
  [[nodiscard]] double run_offset() const;
  /// (n/n_max)^p at a row [1].
  [[nodiscard]] double growth_at(const Record& record, std::size_t row) const;
};

/// Parts of the noise that may be switched off, to see what they are for.
struct NoiseOptions {
  bool correlation = true;
  bool runs = true;
  bool absolute = true;
  bool outliers = true;
  bool growth = true;
};

/// Readings of one channel as its noise is looked for.
struct ChannelReadings {
  Eigen::VectorXd measured{};  ///< SI
  Eigen::VectorXd std{};       ///< declared [SI]; empty where not every reading has one
  bool known = false;          ///< `std` is as good as known
  /// Change of each as a scattering input changes by the width of a level [SI]; empty where no
  /// input scatters.
  Eigen::VectorXd slope{};
  /// Standard deviation of means from the scatter within them, up to a factor; empty for rows.
  Eigen::VectorXd within{};
  /// The input that records sweep [SI, > 0]; null and empty where nothing is swept widely.
  const Channel* swept_by = nullptr;
  Eigen::VectorXd swept{};
  /// Level of each reading, of each setting that stands at few.
  std::vector<std::vector<std::size_t>> levels{};
  RowOrder order{};
  std::vector<std::size_t> part{};                  ///< the joined record of each; may be empty
  std::vector<std::vector<std::size_t>> repeats{};  ///< readings at the same point
};

[[nodiscard]] ChannelReadings readings_of(const Record& record, const Observations& observed,
                                          std::size_t channel);

/// Noise from the saturated regression `columns` (SI, full rank) by restricted maximum likelihood.
/// `size` is a typical reading of each [SI, > 0]; it only decides the first weights.
/// Readings further off than scatter is, as rare as 3.5 standard deviations of a known law, count
/// the less the further they are, and are no degree of freedom. Scatter that grows with the swept
/// input is looked for before any reading is called an outlier, and what gathers at one level of a
/// setting is none.
[[nodiscard]] NoiseModel estimate_noise_model(const ChannelReadings& readings,
                                              const Eigen::MatrixXd& columns,
                                              const Eigen::VectorXd& size,
                                              const NoiseOptions& options = {});

/// Whitening by the same noise for other readings of its channel, of typical sizes `size` [SI].
[[nodiscard]] Whitening whitening_of(const NoiseModel& noise, const ChannelReadings& readings,
                                     const Eigen::VectorXd& size);

/// Error in excess of the noise, both root mean squares: sqrt(error² - noise²), 0 if the error is
/// less.
[[nodiscard]] double beyond_noise(double error, double noise);

/// Counts what a model leaves by its own coarseness as scatter: `error` [SI], equal at every
/// reading, in addition to the noise.
void add_model_error(NoiseModel& noise, const ChannelReadings& readings, double error);

/// Noise that is known beforehand: the standard deviation of every reading, readings independent.
/// For a regression that has measured the scatter of far more samples than it gives readings.
[[nodiscard]] NoiseModel known_noise_model(const ChannelReadings& readings);

}  // namespace raceway::fit
