#pragma once

#include <Eigen/Core>
#include <vector>

namespace raceway::fit {

/// Position of each reading in time, for correlated noise. Readings are in this order.
struct RowOrder {
  /// Time since the row before, in units of the median step [1]; infinite where the correlation
  /// starts anew, also in the first row.
  std::vector<double> step;
  std::vector<bool> new_run;    ///< the row belongs to another run than the row before
  std::vector<bool> new_state;  ///< it belongs to another dwell than the row before
  /// True if the row begins a block that may be an undeclared run; empty if there is none.
  std::vector<bool> new_block;
  /// In each such block the swept input, the first setting, goes one way at a level of another
  /// setting that no other block has.
  bool own_levels = false;
  double median_step = 1.0;  ///< the unit of the steps [s]
  bool has_time = false;     ///< steps mean something
  bool has_runs = false;     ///< two or more runs
  bool has_states = false;   ///< some dwell has several rows
};

/// Turns readings into independent numbers of unit variance.
///
///   cov(e_i, e_k) = s_i s_k [ (1 - g - h) φ^|t_i - t_k| + g r_i r_k (same run) + h (same dwell) ]
///
/// with the standard deviation s of each reading [SI], a first-order autoregression along time and
/// offsets common to the rows of a run and of a dwell. r = 1 where the offset of a run goes with s;
/// r_i = u/s_i where it is the same at each of its readings, as that of a zero that is set before
/// the run; then the variance of a reading is no longer s² alone. Of a reading with a white part,
/// of which neighbours know nothing, c s stands in place of s, and s² (1 - c²) is added to its own
/// variance. Innovations of the Kalman filter with these states, divided by their standard
/// deviation: exact, in time and memory proportional to the rows.
class Whitening {
 public:
  Whitening() = default;
  /// correlation φ in [0, 1), run_share g and state_share h in [0, 1), both together below 1.
  /// `common`: c of each reading, in (0, 1]; 1 where empty. `run_unit`: u [SI]; 0: r = 1.
  Whitening(Eigen::VectorXd std, const RowOrder& order, double correlation, double run_share,
            double state_share = 0.0, const Eigen::VectorXd& common = {}, double run_unit = 0.0);
  /// Whitening of several channels, one after the other, with independent noise.
  explicit Whitening(const std::vector<Whitening>& parts);

  [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const;
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& column) const;
  /// Whitening with standard deviations larger by a factor.
  [[nodiscard]] Whitening scaled(double factor) const;
  /// ln of the determinant of the covariance.
  [[nodiscard]] double log_determinant() const { return log_determinant_; }
  [[nodiscard]] const Eigen::VectorXd& std() const { return std_; }

 private:
  struct Step {
    double decay;  // of the autoregressive state since the row before
    bool new_run;  // the offset starts anew
    double gain_ar, gain_run;
    bool new_state = true;
    double gain_state = 0.0, common = 1.0;
    double run = 1.0;          // r
    double inverse_std = 1.0;  // of the innovation
  };
  template <std::size_t count>
  void follow(double* first, Eigen::Index stride) const;

  Eigen::VectorXd std_;
  std::vector<Step> steps_;  // empty where rows are independent
  double log_determinant_ = 0.0;
};

}  // namespace raceway::fit
