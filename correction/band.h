#pragma once

#include <vector>

#include "correction/correction_subject.h"
#include "correction/range.h"

namespace raceway::correction {

/// How far a displacement may lie from its prediction, at every row of a record [m].
struct Band {
  std::vector<double> of_numbers{};  ///< standard error by those that were fitted
  /// The same by the first rows, from which temperatures count: what the last digit of a sensor
  /// hides there stays in all that follows, in this record as in that of the numbers, whose offset
  /// has it.
  std::vector<double> of_beginning{};
  double of_what_is_left = 0.0;        ///< standard deviation
  std::vector<double> extrapolated{};  ///< see extrapolated()
  /// Half the width of the 95 % band:
  ///
  ///   1.96 sqrt(gᵀ C g + b² + r²) + e
  ///
  /// g = ∂y/∂θ, C the covariance of the numbers; b² the sum over sensors of (∂y/∂T1)² q²/12, T1
  /// what stands in the first row, q its last digit where the record shows one; r the RMS of what
  /// the model left of its readings, on parts that no fit saw; e what of the prediction comes from
  /// beyond what was seen. Beyond, the band holds all from "nothing more than at the edge" to
  /// "twice as much as the model says". Domain:   from rest; of a warm machine its first states and
  /// the constant, which come from the
  ///           readings of this record, count as known.
  /// Accuracy: linear in the numbers, g by central differences along the axes of C.
  [[nodiscard]] std::vector<double> half_width() const;
};

/// Of a model of which it is known what it left; without a covariance of its numbers these count as
/// known. `subject` is the model aligned() with the record of
/// the series.
[[nodiscard]] Band band_of(const CorrectionSubject& subject, const Model& model,
                           const std::shared_ptr<const Series>& series, const Beyond& beyond);

}  // namespace raceway::correction
