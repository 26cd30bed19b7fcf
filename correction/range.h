#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "verdict/calibrate.h"

/// Range of the data that the numbers of a model come from, and departures of a record from it.
namespace raceway::correction {

/// Fills in what every input did on a record up to its last reading, and all of them at once.
void see(Model& model, const record::Record& record);

/// The model of a calibration on a record, with the ranges and evidence of the record, the
/// covariance of the fitted numbers and the residual.
[[nodiscard]] Model trusted(const verdict::Calibration& found, const record::Record& record);

/// Removes everything that belongs to another record: ranges, covariance, residual, evidence.
void forget_what_was_seen(Model& model);

/// Range in the data of the fit: of a column, all but temperatures by their absolute value [SI]; of
/// the speed [rpm]; of the power of a channel [W]. Unbounded where nothing is known.
[[nodiscard]] Interval seen_of(const Model& model, const Channel& column);
[[nodiscard]] Interval seen_speed(const Model& model);
[[nodiscard]] Interval seen_power(const Model& model, const DrivenChannel& channel);
/// Range of the one input of a delay element, in the unit of its column.
[[nodiscard]] Interval seen_by_element(const Model& model, const DrivenChannel& channel);

/// Distance of inputs x (of `columns`, SI, all but temperatures by their absolute value) from their
/// mean in the data of the fit [1].
///
///   d = sqrt(zᵀ (R + 0.01 I)^-1 z),   z = (x - mean)/std, R their correlation
///
/// The distance of [Mahalanobis1936], which grows with the spread of an input and where correlated
/// inputs part. 0.01: two exactly correlated inputs may differ by a tenth of their spread before
/// that counts as one spread.
class Distance {
 public:
  explicit Distance(const SeenTogether& seen);
  [[nodiscard]] double operator()(const Eigen::VectorXd& x) const;

  /// d² = |weights z|²; lower triangle. For controls.
  [[nodiscard]] const Eigen::MatrixXd& weights() const { return weights_; }

 private:
  Eigen::VectorXd mean_, std_;
  Eigen::MatrixXd weights_;
};

/// Departures of a record from the range of the fit.
struct Beyond {
  struct Part {
    const Channel* column = nullptr;  ///< null: a power, or the inputs together
    std::string name{};               ///< of the column or the channel; empty: the inputs together
    double lower = unset, upper = unset;  ///< SI; of the inputs together the distance, from 0 on
    std::size_t rows = 0, first = 0;      ///< how many, and from which row on
    double value = unset;                 ///< at the first of them
    double farthest = unset;              ///< of all values
    [[nodiscard]] bool together() const { return name.empty(); }
  };
  std::vector<Part> parts{};   ///< that the record leaves, inputs first
  std::vector<bool> at_row{};  ///< whether any is left there
  bool known = false;          ///< the model says what was seen
  [[nodiscard]] std::size_t rows() const;
};
[[nodiscard]] Beyond beyond_range(const Model& model, const Series& series);

/// Part of the prediction from outside the range of the fit, at every row [m]: the sum over parts
/// of |part - part with each input limited to its range, and all of them moved towards their mean
/// until they are inside the joint range|. 0 at all rows of a record within the range.
[[nodiscard]] std::vector<double> extrapolated(const Model& model, const Series& series,
                                               const Beyond& beyond);

}  // namespace raceway::correction
