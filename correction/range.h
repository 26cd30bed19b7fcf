#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "verdict/calibrate.h"

/// Stores the input ranges of a fit and finds the rows of a record outside these ranges.
namespace raceway::correction {

/// Stores the range of every input in a record up to its last reading, and the joint range of the
/// inputs.
void see(Model& model, const record::Record& record);

/// Returns the calibrated model with the ranges and evidence of the record, the covariance of the
/// fitted parameters, and the size of the residual.
[[nodiscard]] Model trusted(const verdict::Calibration& found, const record::Record& record);

/// Removes from the model the results of its fit to another record: ranges, covariance, residual
/// and evidence.
void forget_what_was_seen(Model& model);

/// Returns the range in the data of the fit: of a column [SI] (absolute values of speeds, feeds and
/// coolant), of the speed [rpm], or of the power of a channel [W]. The range is unbounded if it is
/// unknown.
[[nodiscard]] Interval seen_of(const Model& model, const Channel& column);
[[nodiscard]] Interval seen_speed(const Model& model);
[[nodiscard]] Interval seen_power(const Model& model, const DrivenChannel& channel);
/// Returns the range of the input of a delay element, in the unit of its column.
[[nodiscard]] Interval seen_by_element(const Model& model, const DrivenChannel& channel);

/// Distance of inputs x from their mean in the data of the fit [1]. x has the order of
/// SeenTogether::columns, in SI, with absolute values of speeds, feeds and the coolant state.
///
///   d = sqrt(zᵀ (R + 0.01 I)^-1 z),   z = (x - mean)/std, R: correlation of the inputs
///
/// This is the distance of [Mahalanobis1936]. The distance grows with the deviation of one input
/// from the mean, in units of the spread of this input. The distance also grows if correlated
/// inputs do not follow their correlation. The term 0.01 I keeps d finite for exactly correlated
/// inputs: if two of them differ by 0.14 of their standard deviation, d is 1.
class Distance {
 public:
  explicit Distance(const SeenTogether& seen);
  [[nodiscard]] double operator()(const Eigen::VectorXd& x) const;

  /// Returns the weights with d = |weights z|, a lower triangular matrix. Exported control programs
  /// use this matrix.
  [[nodiscard]] const Eigen::MatrixXd& weights() const { return weights_; }

 private:
  Eigen::VectorXd mean_, std_;
  Eigen::MatrixXd weights_;
};

/// Rows of a record outside the range of the fit.
struct Beyond {
  struct Part {
    const Channel* column = nullptr;  ///< null: a power, or the joint range of inputs
    std::string name{};  ///< name of the column or channel; empty: the joint range of inputs
    /// [SI]; for the joint range: limits of the distance, from 0.
    double lower = unset, upper = unset;
    std::size_t rows = 0, first = 0;  ///< number of rows, and the first of them
    double value = unset;             ///< value in the row `first`
    double farthest = unset;          ///< value farthest outside the range
    [[nodiscard]] bool together() const { return name.empty(); }
  };
  std::vector<Part> parts{};   ///< exceeded ranges, inputs first
  std::vector<bool> at_row{};  ///< true for rows outside any range
  bool known = false;          ///< true if the model contains its ranges
  [[nodiscard]] std::size_t rows() const;
};
[[nodiscard]] Beyond beyond_range(const Model& model, const Series& series);

/// Returns the extrapolated part of the prediction at every row [m]. The extrapolated part is the
/// sum of |part - part with limited inputs| over the parts of the model. To limit the inputs, each
/// input is first limited to its range. Then all inputs are moved towards their mean until they are
/// inside the joint range. The result is 0 if no row is outside a range. After a row outside a
/// range, the result stays above 0 for some time, because lags have memory.
[[nodiscard]] std::vector<double> extrapolated(const Model& model, const Series& series,
                                               const Beyond& beyond);

}  // namespace raceway::correction
