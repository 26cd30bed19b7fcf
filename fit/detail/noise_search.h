#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include "fit/noise_model.h"

/// Part of estimate_noise_model().
namespace raceway::fit {

/// The search for the noise of one channel, part by part.
class NoiseSearch {
 public:
  static constexpr double as_good_as_known = 1000.0;  ///< degrees of freedom

  /// Shares of the variance: in proportion to the reading, from the scatter of an input, the rest
  /// absolute.
  struct Shares {
    double relative = 1.0, input = 0.0;
    [[nodiscard]] double absolute() const { return std::max(0.0, 1.0 - relative - input); }
    [[nodiscard]] int parts() const {
      return (relative > 0.0 ? 1 : 0) + (input > 0.0 ? 1 : 0) + (absolute() > 0.0 ? 1 : 0);
    }
  };

  /// Parts of the standard deviations, each with an rms of one.
  struct Parts {
    Eigen::VectorXd reading, own, slope;
  };

  NoiseSearch(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
              const Eigen::VectorXd& size, const NoiseOptions& options);
  NoiseModel run();

 private:
  /// Least squares with orthogonal columns kept: residual, and how much of each row is left to it.
  struct Regression {
    Eigen::VectorXd fitted;    ///< whitened
    Eigen::VectorXd residual;  ///< whitened
    Eigen::VectorXd freedom;   ///< 1 - leverage
    double log_determinant;    ///< of XᵀV⁻¹X
  };
  static Regression regress(const Eigen::MatrixXd& x, const Eigen::VectorXd& y);
  /// Shape of the standard deviations, at some of the readings.
  static Eigen::VectorXd shape(const Shares& shares, const Parts& parts,
                               const Eigen::VectorXd& widening);
  static Eigen::VectorXd of_rms_one(const Eigen::VectorXd& v);

  [[nodiscard]] double misfit(double phi, double run_share, const Shares& shares) const;
  /// Share of each standard deviation that neighbours can have in common. Scatter within a dwell
  /// and of an input is excluded; single rows have no excluded part.
  [[nodiscard]] Eigen::VectorXd common(const Shares& shares, const Parts& parts) const;
  /// A reading by its size, with the growth of the noise over the swept input.
  [[nodiscard]] Eigen::VectorXd grown(const Eigen::VectorXd& reading) const;
  /// Factor by which a standard deviation exceeds that of its parts.
  [[nodiscard]] Eigen::VectorXd stretched() const { return widening_.cwiseProduct(by_record_); }
  [[nodiscard]] std::vector<Shares> all_shares() const;
  double find_shares() { return find_shares(all_shares()); }
  [[nodiscard]] static double cost(const Shares& shares);
  /// The best of these with the memory as it is; its -2 ln L with what its parts cost.
  double find_shares(const std::vector<Shares>& list);
  /// Finds the growth of the relative part with the swept input. Each growth has its own doubtful
  /// readings, and each of these costs what its rarity is worth.
  void find_growth();
  /// Quick test: logarithms of the residuals of the saturated regression against the logarithm of
  /// the swept input. ln |z| of a normal law has a standard deviation of 1.11.
  [[nodiscard]] bool seems_to_grow() const;
  /// Readings that gather at one level of a setting are no outliers: there the rig scatters more.
  void spare_levels();
  /// First doubts, from a regression of few columns that outliers cannot bend to themselves, as
  /// they do with one that has half as many columns as rows: reweighted by Tukey's biweight from
  /// least absolute deviations. find_outliers() takes back unfounded doubts.
  void suspect_outliers();
  void find_outliers();
  /// Finds the scatter of each of several records, in the common shape: days and sensors differ.
  void find_records();
  /// Correlation and runs both at once, as each can look like the other; offsets of runs in
  /// proportion to the noise of each reading, or the same for all readings of a run.
  void find_memory();
  /// The best correlation and share of runs with the other parts as they are.
  void search_memory(bool timed, bool runs);
  /// -2 ln L with what memory and parts cost.
  [[nodiscard]] double value() const;
  /// Whitening::run_unit for standard deviations of this shape.
  [[nodiscard]] double run_unit(const Eigen::VectorXd& std) const;
  /// Finds the offset that the pieces of one dwell have in common. It competes with the correlation
  /// between neighbours, so both are searched together.
  void find_states();
  /// Finds offsets that follow blocks of rows not declared as runs.
  void find_blocks();
  /// Whitening scaled to the residuals of the regression.
  [[nodiscard]] Whitening scaled(double phi, double run_share, const Shares& shares,
                                 double& factor) const;
  void set_scale();
  /// Declared standard deviations that the readings do not contradict are taken as they are.
  void honour_declared(double& factor);
  /// Shapes whose likelihood is within reach of the best: each part of the noise to both ends of
  /// what the readings allow, and no memory where they allow that.
  void find_allowed();
  /// Less growth and more, as far as the readings allow.
  void allow_growths(double phi, double g, double best);
  /// Pure error as a check.
  void hold_against_repeats();
  const ChannelReadings& readings_;
  const Eigen::MatrixXd& columns_;
  const Eigen::VectorXd& size_;
  const NoiseOptions& options_;
  Eigen::Index rows_;
  std::vector<Eigen::Index> some_;
  RowOrder order_, some_order_;
  Eigen::MatrixXd some_columns_;
  Eigen::VectorXd some_deviation_;
  bool declared_;
  Parts parts_;
  double reading_size_ = unset;  // rms of what Parts::reading has without its scale [SI]
  Eigen::VectorXd widening_;     // of outliers
  Eigen::VectorXd by_record_;    // NoiseModel::records
  Shares shares_;
  bool even_runs_ = false;  // the offset of a run is the same for all of its readings
  NoiseModel noise_;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double worth_a_parameter = 2.71;  // of -2 ln L: 5 % level of one variance >= 0
  static constexpr double within_the_likely = 2.71;  // the same: 90 % of one parameter
};

}  // namespace raceway::fit
