#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/data_set.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// What is scatter in a data set: its size, its growth with the torque, its memory.
///
///   s_i² = (relative M_i)² + (absolute a_i)²      a_i = 1, or the declared std over its rms
///
/// and the correlation of Whitening. Found from what a saturated regression leaves, never from
/// the misfit of a physical model, which would call missing physics noise.
struct NoiseModel {
  double relative = 0.0;              ///< standard deviation in proportion to the reading [1]
  double absolute = 0.0;              ///< rms of the part that does not grow with it, SI
  double correlation = 0.0;           ///< φ of neighbours in time, at the median step [1]
  double run_share = 0.0;             ///< of the variance, common to the rows of a run [1]
  double degrees_of_freedom = unset;  ///< of the variance
  Whitening whitening;
  std::vector<std::size_t> outliers;  ///< rows counted with less weight, none left out
  double rms = unset;                 ///< over the rows, SI
  /// Repeats against the saturated regression: F and its p; NaN below 8 degrees of freedom.
  double repeats_statistic = unset, repeats_p_value = unset;
};

/// Parts of the noise that may be switched off, to see what they are for.
struct NoiseOptions {
  bool correlation = true;
  bool runs = true;
  bool absolute = true;
  bool outliers = true;
};

/// Order of the rows for correlated noise. Rows must stand in time order already.
[[nodiscard]] RowOrder row_order(const DataSet& data);

/// Puts rows in the one order that all of the diagnosis uses, whatever order the file had: by time
/// where all rows have one (within runs, if runs overlap in time), then by operating point.
void sort_rows(DataSet& data);

/// Noise from the saturated regression `columns` (SI, full rank) by restricted maximum likelihood.
/// `size` is a typical reading of each row [SI, > 0]; it only decides the first weights.
/// Rows further than 3.5 robust standard deviations off are counted with the deviation they have.
[[nodiscard]] NoiseModel estimate_noise_model(const DataSet& data, const Eigen::MatrixXd& columns,
                                              const Eigen::VectorXd& size,
                                              const NoiseOptions& options = {});

/// Noise that is known beforehand: the standard deviation of every row, rows independent. For the
/// torques of a coast-down, whose regression has measured the scatter of far more samples than
/// rows.
[[nodiscard]] NoiseModel known_noise_model(const DataSet& data);

}  // namespace raceway::fit
