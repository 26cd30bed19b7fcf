#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Position of each reading in time, in runs and in dwells, for the model of correlated noise. Each
/// vector has one entry for each reading.
struct RowOrder {
  /// Time since the previous row, divided by `median_step` [1]. The value is infinite for the first
  /// row and for every row that is not correlated with the previous row.
  std::vector<double> step;
  std::vector<bool> new_run;    ///< true if the row and the previous row belong to different runs
  std::vector<bool> new_state;  ///< true if the row and the previous row belong to different dwells
  /// True if the row begins a block that may be an undeclared run. The vector is empty if there are
  /// no such blocks.
  std::vector<bool> new_block;
  /// True if the blocks of `new_block` are probably runs: the first setting of the record, usually
  /// the speed, only rises or only falls within a block, and a load is constant in each block but
  /// differs between all blocks. If the record has times, the breaks between blocks must also be
  /// longer than the steps within blocks.
  bool own_levels = false;
  double median_step = 1.0;  ///< median time between rows [s]; 1 if the record has no times
  bool has_time = false;     ///< true if `step` comes from recorded times
  bool has_runs = false;     ///< true if the record has two or more runs
  bool has_states = false;   ///< true if at least one dwell has several rows
};

/// Transforms readings into independent numbers of unit variance.
///
///   cov(e_i, e_k) = s_i s_k [ (1 - g - h) φ^|t_i - t_k| + g r_i r_k (same run) + h (same dwell) ]
///
/// e_i is the noise of reading i, s_i [SI] its standard deviation, and t_i its time in units of the
/// median step. The terms with g and h apply only to two readings of the same run or dwell. The
/// noise is a first-order autoregressive process with the correlation φ, plus one offset for each
/// run and one offset for each dwell. g and h are the shares of the run offsets and the dwell
/// offsets in the variance.
///
/// If the run offset of each reading is proportional to s_i, r_i is 1. If the offset is equal for
/// all readings of a run, for example because the sensor is set to zero before each run, r_i is
/// u/s_i with the size u of the run offsets [SI]. The variance of a reading then differs from s_i².
///
/// A part of the noise of a reading may be independent of all other readings. In the equation
/// above, c_i s_i then replaces s_i, and the variance of the independent part is s_i² (1 - c_i²).
///
/// The transformed readings are the innovations of a Kalman filter, divided by their standard
/// deviations. The state of the filter consists of the autoregressive noise, the run offset and the
/// dwell offset. The transformation is exact and needs time and memory proportional to the number
/// of rows.
class Whitening {
 public:
  Whitening() = default;
  /// The symbols are defined at the class. `std` contains s_i [SI]. `correlation` is φ, `run_share`
  /// is g and `state_share` is h; all are in [0, 1), and g + h is below 1. `common` contains c_i,
  /// in (0, 1]; if it is empty, c_i is 1. `run_unit` is u [SI]; if it is 0, r_i is 1.
  Whitening(Eigen::VectorXd std, const RowOrder& order, double correlation, double run_share,
            double state_share = 0.0, const Eigen::VectorXd& common = {}, double run_unit = 0.0);
  /// Combines the whitenings of several channels. The vectors contain all readings of the first
  /// channel, then all readings of the second, and so on. The noise of different channels is
  /// independent.
  explicit Whitening(const std::vector<Whitening>& parts);

  /// Returns the transformed columns. A column has one entry for each reading.
  [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const;
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& column) const;
  /// Returns a copy with all standard deviations multiplied by a factor.
  [[nodiscard]] Whitening scaled(double factor) const;
  /// Returns ln of the determinant of the covariance matrix of the readings [SI].
  [[nodiscard]] double log_determinant() const { return log_determinant_; }
  [[nodiscard]] const Eigen::VectorXd& std() const { return std_; }

 private:
  struct Step {
    double decay;  // decay of the autoregressive state since the previous row
    bool new_run;  // true if a new run offset begins
    double gain_ar, gain_run;
    bool new_state = true;
    double gain_state = 0.0, common = 1.0;
    double run = 1.0;          // r
    double inverse_std = 1.0;  // 1 / standard deviation of the innovation
  };
  template <std::size_t count>
  void follow(double* first, Eigen::Index stride) const;

  Eigen::VectorXd std_;
  std::vector<Step> steps_;  // empty if the rows are independent
  double log_determinant_ = 0.0;
};

}  // namespace raceway::fit
