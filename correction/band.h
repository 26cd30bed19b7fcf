#pragma once

#include <vector>

#include "correction/correction_subject.h"
#include "correction/range.h"

namespace raceway::correction {

/// Uncertainty of a predicted displacement at every row of a record [m].
struct Band {
  std::vector<double> of_numbers{};  ///< standard error from the fitted numbers
  /// Standard error from the first rows, from which temperatures count: the resolution of a sensor
  /// there shifts all later rows, in this record as in the record of the fit, whose offset contains
  /// it.
  std::vector<double> of_beginning{};
  double of_what_is_left = 0.0;        ///< standard deviation of the residual
  std::vector<double> extrapolated{};  ///< see extrapolated()
  /// Half width of the 95 % band:
  ///
  ///   1.96 sqrt(gᵀ C g + b² + r²) + e
  ///
  /// g = ∂y/∂θ, C the covariance of the numbers; b² the sum over sensors of (∂y/∂T1)² q²/12, T1 the
  /// value in the first row, q its resolution if the record shows one; r the RMS of the residual on
  /// parts that no fit saw; e the part of the prediction from outside the range of the fit.
  /// Outside, the band covers everything from "nothing more than at the edge" to "twice as much as
  /// the model says".
  ///
  /// Domain:   from rest; for a warm machine its initial states and the constant, which come from
  ///           the readings of this record, count as exact.
  /// Accuracy: linear in the numbers, g by central differences along the axes of C.
  [[nodiscard]] std::vector<double> half_width() const;
};

/// Returns the band of a model whose residual is known. Without a covariance the numbers count as
/// exact. `subject` is the model aligned() with the record of the series.
[[nodiscard]] Band band_of(const CorrectionSubject& subject, const Model& model,
                           const std::shared_ptr<const Series>& series, const Beyond& beyond);

}  // namespace raceway::correction
