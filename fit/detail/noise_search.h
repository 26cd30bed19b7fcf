#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "algebra/detail/decompositions.h"
#include "fit/noise_model.h"

/// Search for the most likely noise model: estimate_noise_model().
namespace raceway::fit {

/// Regression of whitened readings on columns, with its restricted likelihood. All variances have a
/// common factor, for which the most likely value is used.
class RestrictedFit {
 public:
  /// `deviation` is the difference between the readings and any linear combination of the columns.
  /// The choice of this combination changes only rounding errors.
  RestrictedFit(const Whitening& whitening, const Eigen::MatrixXd& columns,
                const Eigen::VectorXd& deviation);

  /// Returns -2 ln of the restricted likelihood.
  [[nodiscard]] double misfit() const { return misfit_; }
  /// Returns the sum of the squared residuals [1].
  [[nodiscard]] double square() const { return square_; }
  [[nodiscard]] double freedom() const { return static_cast<double>(x_.rows() - x_.cols()); }
  /// Returns the residual of each row, whitened.
  [[nodiscard]] Eigen::VectorXd residual() const;
  /// Returns the leverage of each row.
  [[nodiscard]] Eigen::VectorXd leverage() const;

 private:
  Eigen::MatrixXd x_;
  Eigen::VectorXd y_;
  algebra::LowerRoot root_;    // of XᵀX
  Eigen::VectorXd projected_;  // Xᵀy
  double square_, misfit_;
};

/// Variances of the readings for several cases, up to a common factor. A case is a set of shares of
/// the parts of the noise.
struct Variances {
  Eigen::MatrixXd parts;   ///< variance from each part of the noise (readings x parts)
  Eigen::MatrixXd shares;  ///< shares of the parts (parts x cases)
  [[nodiscard]] Eigen::VectorXd operator[](Eigen::Index column) const {
    return parts * shares.col(column);
  }
};

/// Estimates the parts of the noise of one channel, one after the other.
class NoiseSearch {
 public:
  /// Degrees of freedom above which the noise is treated as exact.
  static constexpr double as_good_as_known = 1000.0;

  /// Shares of the variance: `relative` for noise proportional to the reading, and `input` for
  /// noise from the scatter of inputs. The rest of the variance is absolute noise.
  struct Shares {
    double relative = 1.0, input = 0.0;
    [[nodiscard]] double absolute() const { return std::max(0.0, 1.0 - relative - input); }
    [[nodiscard]] int parts() const {
      return (relative > 0.0 ? 1 : 0) + (input > 0.0 ? 1 : 0) + (absolute() > 0.0 ? 1 : 0);
    }
  };

  /// Memory of the noise: the correlation of neighbours and the offsets of runs.
  struct Memory {
    double correlation, run_share;  ///< as in NoiseModel
    Shares shares;
    bool even_runs;  ///< true if the offset of a run is equal for all its readings
  };

  /// Shapes of the three parts of the standard deviations, each with an RMS of 1 over the readings:
  /// `reading` for the relative part, `own` for the absolute part, and `slope` for the part from
  /// the scatter of inputs (empty if no input scatters).
  struct Parts {
    Eigen::VectorXd reading, own, slope;
  };

  NoiseSearch(const ChannelReadings& readings, const Eigen::MatrixXd& columns,
              const Eigen::VectorXd& size, const NoiseOptions& options);
  NoiseModel run();

 private:
  /// Least-squares regression with orthogonal columns: residual, and remaining degrees of freedom
  /// of each row.
  struct Regression {
    Eigen::VectorXd fitted;    ///< whitened
    Eigen::VectorXd residual;  ///< whitened
    Eigen::VectorXd freedom;   ///< 1 - leverage of each row
  };
  static Regression regress(const Eigen::MatrixXd& x, const Eigen::VectorXd& y);
  /// Returns relative standard deviations of the readings to which `parts` belongs.
  static Eigen::VectorXd shape(const Shares& shares, const Parts& parts,
                               const Eigen::VectorXd& widening);
  static Eigen::VectorXd of_rms_one(const Eigen::VectorXd& v);

  [[nodiscard]] RestrictedFit restricted(double phi, double run_share, const Shares& shares) const;
  [[nodiscard]] double misfit(double phi, double run_share, const Shares& shares) const {
    return restricted(phi, run_share, shares).misfit();
  }
  /// Returns Parts with only the readings that the search uses.
  [[nodiscard]] Parts some_parts() const;
  /// Returns the share of each standard deviation that neighbours can have in common. This share
  /// excludes the scatter within a dwell and the scatter of an input. The result is empty for
  /// single rows and for declared standard deviations, because nothing is then excluded.
  [[nodiscard]] Eigen::VectorXd common(const Shares& shares, const Parts& parts) const;
  /// Returns each reading multiplied by the growth factor (n/n_max)^p of NoiseModel.
  [[nodiscard]] Eigen::VectorXd grown(const Eigen::VectorXd& reading) const;
  /// Returns the factor of each standard deviation for outliers and for its joined record [1].
  [[nodiscard]] Eigen::VectorXd stretched() const { return widening_.cwiseProduct(by_record_); }
  [[nodiscard]] std::vector<Shares> all_shares() const;
  double find_shares() { return find_shares(all_shares()); }
  [[nodiscard]] static double cost(const Shares& shares);
  /// Finds the most likely of these shares for the current memory. Returns their -2 ln L plus
  /// cost(), a penalty for each part of the noise after the first and for scatter of inputs.
  double find_shares(const std::vector<Shares>& list);
  /// Returns the shares whose -2 ln L is below a limit, for the current memory.
  [[nodiscard]] std::vector<Shares> shares_below(double limit) const;
  /// Returns -2 ln L plus cost for each of these shares. The value is infinite for shares that are
  /// certainly above `limit`. If `costs` is not empty, the limit falls to the smallest value found
  /// so far.
  [[nodiscard]] std::vector<double> values(const std::vector<Shares>& list,
                                           const std::vector<double>& costs, double limit) const;
  [[nodiscard]] Variances variances_of(const std::vector<Shares>& list) const;
  /// Finds the exponent by which the relative part grows with the swept input. For each exponent,
  /// the function marks the possible outliers again, and each of them adds a cost to -2 ln L.
  void find_growth();
  /// Quick test: fits the logarithms of the residuals of the saturated regression as a function of
  /// the logarithm of the swept input. If z is a normal variable with mean 0, ln |z| has a standard
  /// deviation of 1.11.
  [[nodiscard]] bool seems_to_grow() const;
  /// Removes the marks of possible outliers that gather at one level of a setting. The rig scatters
  /// more at that level, so these readings are not outliers.
  void spare_levels();
  /// Marks readings that may be outliers, with a regression of few columns: at most one for six
  /// rows. Outliers influence this regression less than a regression with more columns. The
  /// regression starts from least absolute deviations and reweights by Tukey's biweight.
  /// find_outliers() later removes the wrong marks.
  void suspect_outliers();
  void find_outliers();
  /// Finds the size of the scatter in each joined record, because days and sensors differ. All
  /// records share one shape of the noise.
  void find_records();
  /// Finds correlation and run offsets together, because each can look like the other. Run offsets
  /// are either proportional to the noise of each reading or equal for all readings of a run.
  void find_memory();
  [[nodiscard]] Memory memory() const;
  void recall(const Memory& memory);
  /// Returns the share of the noise variance that dwell offsets leave to the other parts.
  [[nodiscard]] double beside_states() const { return 1.0 - noise_.state_share; }
  /// Finds the best correlation and run share, with the other parts fixed.
  void search_memory(bool timed, bool runs);
  /// Returns -2 ln L plus cost(), plus worth_a_parameter if the correlation is not 0, plus
  /// worth_a_parameter if the run share is not 0.
  [[nodiscard]] double value() const;
  /// Returns the argument `run_unit` of Whitening for these standard deviations.
  [[nodiscard]] double run_unit(const Eigen::VectorXd& std) const;
  /// Finds the share of the offset that is common to all rows of one dwell (a dwell in which a
  /// temperature drifts has several rows). The offset can look like the correlation between
  /// neighbours, so the search varies both together.
  void find_states();
  /// Finds offsets of blocks of rows that are not declared as runs.
  void find_blocks();
  /// Returns a whitening that is scaled to the residuals of the regression.
  [[nodiscard]] Whitening scaled(double phi, double run_share, const Shares& shares,
                                 double& factor) const;
  void set_scale();
  /// Keeps the declared standard deviations if the readings do not contradict them.
  void honour_declared(double& factor);
  /// Finds noise shapes with a likelihood close to the best. The relative share and the growth are
  /// moved to both ends of the range that the readings allow. The share of the input, the
  /// correlation and the run offsets are moved to the upper end. If the other kind of run offsets
  /// (proportional to the noise, or equal in a run) is almost as likely, a noise shape with these
  /// offsets is added. A noise shape without memory is added if the readings allow it.
  void find_allowed();
  /// Tries stronger correlation and larger run offsets, as far as the readings allow.
  void allow_memory(double best);
  /// Tries weaker and stronger growth, as far as the readings allow.
  void allow_growths(double phi, double g, double best);
  /// Compares the result with the scatter within repeats.
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
  double reading_size_ = unset;  // rms of Parts::reading before scaling [SI]
  Eigen::VectorXd widening_;     // factor on the standard deviation of outliers
  Eigen::VectorXd by_record_;    // NoiseModel::records
  Shares shares_;
  bool even_runs_ = false;       // Memory::even_runs
  std::optional<Memory> rival_;  // the other form of run offsets, where it is almost as likely
  NoiseModel noise_;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // threshold in -2 ln L: 5 % level of one variance >= 0
  static constexpr double worth_a_parameter = 2.71;
  // threshold in -2 ln L: 90 % region of one parameter
  static constexpr double within_the_likely = 2.71;
};

}  // namespace raceway::fit
