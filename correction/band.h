#pragma once

#include <vector>

#include "correction/correction_subject.h"
#include "correction/range.h"

namespace raceway::correction {

/// Uncertainty of a predicted displacement at every row of a record [m].
struct Band {
  std::vector<double> of_numbers{};  ///< standard error from the fitted parameters
  /// Standard error from the first row of the record, from which temperatures count. The resolution
  /// of a sensor in that row shifts all later rows, both here and in the record of the fit, whose
  /// offset contains it.
  std::vector<double> of_beginning{};
  double of_what_is_left = 0.0;        ///< standard deviation of the residual
  std::vector<double> extrapolated{};  ///< extrapolated part, see extrapolated()
  /// Returns the half width of the 95 % band:
  ///
  ///   1.96 sqrt(gᵀ C g + b² + r²) + e
  ///
  /// The symbols: g = ∂y/∂θ, and C is the covariance of the parameters. b² is the sum over sensors
  /// of (∂y/∂T1)² q²/12, with the value T1 in the first row and the resolution q, if the record
  /// shows one. r is the rms of the residual on held-out parts. e is the part of the prediction
  /// from outside the range of the fit. Outside this range, the band reaches from the value at the
  /// edge to twice the predicted change beyond the edge.
  ///
  /// Domain:   records that start at rest. For a warm machine, the initial states and the constant
  ///           come from the readings of the record and count as exact.
  /// Accuracy: linear in the parameters; g by central differences along the axes of C.
  [[nodiscard]] std::vector<double> half_width() const;
};

/// Returns the band of a model whose residual is known. Without a covariance, the parameters count
/// as exact. `subject` is the model after aligned() with the record of the series.
[[nodiscard]] Band band_of(const CorrectionSubject& subject, const Model& model,
                           const std::shared_ptr<const Series>& series, const Beyond& beyond);

}  // namespace raceway::correction
