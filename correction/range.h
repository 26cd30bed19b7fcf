#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "verdict/calibrate.h"

/// What the numbers of a model come from, and where a record asks it for something else.
namespace raceway::correction {

/// Fills in what every input did on a record up to its last reading, and all of them at once.
void see(Model& model, const record::Record& record);

/// The model of a calibration on a record, with what that showed, the covariance of what was fitted
/// and what is left.
[[nodiscard]] Model trusted(const verdict::Calibration& found, const record::Record& record);

/// Takes out what is of another record: ranges, covariance, what was left, evidence.
void forget_what_was_seen(Model& model);

/// Of a column, all but temperatures by their amount [SI]; of the speed [rpm], and of the power of
/// a channel [W]; all where nothing is known.
[[nodiscard]] Interval seen_of(const Model& model, const Channel& column);
[[nodiscard]] Interval seen_speed(const Model& model);
[[nodiscard]] Interval seen_power(const Model& model, const DrivenChannel& channel);

/// How far inputs x (of `columns`, SI, all but temperatures by their amount) stand from what was
/// seen together [1].
///
///   d = sqrt(zᵀ (R + 0.01 I)^-1 z),   z = (x - mean)/std, R their correlation
///
/// The distance of [Mahalanobis1936], which grows with the spread of an input and where inputs that
/// went together part. 0.01: two that went together exactly may differ by what a tenth of their
/// spread is, before that counts as one spread.
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

/// Where a record leaves what was seen.
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

/// How much of the prediction comes from beyond what was seen, at every row [m]: the sum over its
/// parts of |part - the same with each input held at the edge of its range, and all of them drawn
/// to their mean until they are no farther than they were together|. 0 at all rows of a record that
/// stays within.
[[nodiscard]] std::vector<double> extrapolated(const Model& model, const Series& series,
                                               const Beyond& beyond);

}  // namespace raceway::correction
