#pragma once

#include <vector>

#include "correction/correction_subject.h"
#include "correction/range.h"

namespace raceway::correction {

/// Uncertainty of a predicted displacement at every row of a record [m].
struct Band {
  std::vector<double> of_numbers{};  ///< standard error from the fitted parameters
  /// Standard error from the first row of each run. Temperatures are relative to the first row, so
  /// an error from the resolution of a sensor in this row shifts the prediction in all later rows
  /// of the run. The record of the fit has a similar error, which is part of the fitted offset.
  std::vector<double> of_beginning{};
  double of_what_is_left = 0.0;        ///< standard deviation of the residual
  std::vector<double> extrapolated{};  ///< extrapolated part, see extrapolated()
  /// Returns the half width of the 95 % band:
  ///
  ///   1.96 sqrt(gᵀ C g + b² + r²) + e
  ///
  /// y is the predicted displacement, g is ∂y/∂θ, and C is the covariance of the parameters θ. b²
  /// is the sum over sensors of (∂y/∂T1)² 2 q²/12, where T1 is the value in the first row and q the
  /// resolution. Sensors without a visible resolution are left out. The factor 2 counts two
  /// records: the predicted record and the record of the fit. r is the rms of the residual on
  /// held-out parts. e is the extrapolated part of the prediction. Outside the range of the fit,
  /// the band reaches from the value at the edge to twice the predicted change beyond the edge.
  ///
  /// Domain:   records that start at rest. For a warm machine, the initial states and the constant
  ///           come from the readings of the record and are assumed exact.
  /// Accuracy: linear in the parameters. g comes from central differences along the axes of C.
  [[nodiscard]] std::vector<double> half_width() const;
};

/// Returns the band of a model. Without a covariance in the model, the parameters are assumed
/// exact; without a residual, r is 0. `subject` is the result of aligned() for this model and the
/// record of `series`.
[[nodiscard]] Band band_of(const CorrectionSubject& subject, const Model& model,
                           const std::shared_ptr<const Series>& series, const Beyond& beyond);

}  // namespace raceway::correction
