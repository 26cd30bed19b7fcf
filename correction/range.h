#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "verdict/calibrate.h"

/// Stores the input ranges of a fit, and finds rows of other records outside these ranges.
namespace raceway::correction {

/// Stores in the model the range that every input has in the record, and the joint range of all
/// inputs (see SeenTogether). Rows after the last reading of the record are not used.
void see(Model& model, const record::Record& record);

/// Returns the calibrated model together with the results of the fit: input ranges, held-out error,
/// covariance of the fitted parameters, and rms residual.
[[nodiscard]] Model trusted(const verdict::Calibration& found, const record::Record& record);

/// Removes the input ranges, covariance, residual and held-out error of an earlier fit from the
/// model.
void forget_what_was_seen(Model& model);

/// Returns the range that an input had in the data of the fit. The range is unbounded if it is
/// unknown. seen_of() returns the range of a column [SI], with absolute values of speeds, feeds and
/// the coolant state. seen_speed() returns the range of the speed [rpm], and seen_power() the range
/// of the power that drives a channel [W].
[[nodiscard]] Interval seen_of(const Model& model, const Channel& column);
[[nodiscard]] Interval seen_speed(const Model& model);
[[nodiscard]] Interval seen_power(const Model& model, const DrivenChannel& channel);
/// Returns the range that the input of a delay element had in the data of the fit [W for a power,
/// otherwise the unit of the input's column]. The range is unbounded if it is unknown.
[[nodiscard]] Interval seen_by_element(const Model& model, const DrivenChannel& channel);

/// Distance d of inputs x from their mean in the data of the fit [1]. x has the order of
/// SeenTogether::columns, in SI, with absolute values of speeds, feeds and the coolant state.
///
///   d = sqrt(zᵀ (R + 0.01 I)^-1 z),   z = (x - mean)/std, R: correlation of the inputs
///
/// Without the term 0.01 I (I: identity matrix), d is the distance of [Mahalanobis1936]. d is large
/// if an input is many standard deviations away from its mean. d is also large if inputs that are
/// correlated in the data of the fit deviate from this correlation. The term 0.01 I keeps d finite
/// for exactly correlated inputs: if two such inputs differ by 0.14 standard deviations, d is 1.
class Distance {
 public:
  explicit Distance(const SeenTogether& seen);
  [[nodiscard]] double operator()(const Eigen::VectorXd& x) const;

  /// Returns the lower triangular matrix W with d = |W z|. Exported control programs use W.
  [[nodiscard]] const Eigen::MatrixXd& weights() const { return weights_; }

 private:
  Eigen::VectorXd mean_, std_;
  Eigen::MatrixXd weights_;
};

/// Rows of a record outside the range of the fit.
struct Beyond {
  struct Part {
    const Channel* column = nullptr;  ///< column of the input; null for a power or the joint range
    std::string name{};               ///< name of the column or channel; empty for the joint range
    /// Limits of the range [SI]. For the joint range, these are the limits of the distance d (see
    /// Distance), with `lower` = 0.
    double lower = unset, upper = unset;
    /// Number of rows outside the range, and the index of the first of these rows.
    std::size_t rows = 0, first = 0;
    double value = unset;     ///< input, or distance d, in the row `first` [SI]
    double farthest = unset;  ///< input, or distance d, farthest outside the range [SI]
    [[nodiscard]] bool together() const { return name.empty(); }
  };
  /// Ranges that the record exceeds. If the record exceeds the joint range of all inputs
  /// (correction.together), this range is the last element.
  std::vector<Part> parts{};
  std::vector<bool> at_row{};  ///< true for each row outside at least one range
  bool known = false;          ///< false: the model has no input ranges to compare with
  [[nodiscard]] std::size_t rows() const;
};
[[nodiscard]] Beyond beyond_range(const Model& model, const Series& series);

/// Returns the size of the extrapolation at every row [m]. For each contribution (see
/// contributions()), the model is also simulated with inputs that are limited to the range of the
/// fit. The result is the sum of the absolute differences between the contributions with original
/// and with limited inputs. To limit the inputs, each input is first clipped to its range. If the
/// distance d then exceeds its limit, the differences of all inputs from their means are multiplied
/// by one common factor, so that d equals the limit. The result is 0 if no row is outside a range.
/// After a row outside a range, the result stays above 0 for some time, because lags have memory.
[[nodiscard]] std::vector<double> extrapolated(const Model& model, const Series& series,
                                               const Beyond& beyond);

}  // namespace raceway::correction
