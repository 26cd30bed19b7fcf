#pragma once

#include <vector>

#include "correction/correction_subject.h"
#include "correction/range.h"

namespace raceway::correction {

/// Uncertainty of a predicted displacement [m]. The lists have one value per row of the record.
struct Band {
  std::vector<double> of_numbers{};  ///< standard error due to the uncertainty of the parameters
  /// Standard error due to the sensor resolution in the first row of each run. The model uses
  /// temperature changes since this row, so a rounding error in this row shifts all predictions of
  /// the run. The record of the fit has its own rounding error, which is part of the fitted offset.
  std::vector<double> of_beginning{};
  double of_what_is_left = 0.0;  ///< rms of the residual [m]: r in half_width()
  /// Change of the prediction by extrapolation beyond the range of the fit [m]: e in half_width().
  std::vector<double> extrapolated{};
  /// Returns the half width of the 95 % band:
  ///
  ///   1.96 sqrt(gᵀ C g + b² + r²) + e
  ///
  /// y is the predicted displacement, g is ∂y/∂θ, and C is the covariance of the parameters θ. b²
  /// is the sum over temperature sensors of (∂y/∂T1)² 2 q²/12, where T1 is the value in the first
  /// row and q is the resolution. The sum leaves out sensors for which quantum_of() finds no
  /// resolution. The factor 2 is necessary because the rounding error occurs in two records: the
  /// predicted record and the record of the fit. r is the rms of the residual on held-out parts. If
  /// no part was held out, r is the rms of the residual of the fit. e is the result of
  /// extrapolated(), the change of the prediction beyond the range of the fit.
  ///
  /// Domain:   records that start with a machine at rest. For a machine that is warm at the start,
  ///           the initial states and the offset are fitted to the record, but the band does not
  ///           include their uncertainty.
  /// Accuracy: the formula treats y as linear in the parameters. g is computed by central
  ///           differences along the principal axes of C.
  [[nodiscard]] std::vector<double> half_width() const;
};

/// Returns the band of a model. If the model has no covariance, the parameters are assumed exact.
/// If the model file does not give the residual of the fit (Model::left), the term r of
/// Band::half_width() is 0. `subject` must come from aligned() for this model and for the record in
/// `series`. `beyond` must come from beyond_range().
[[nodiscard]] Band band_of(const CorrectionSubject& subject, const Model& model,
                           const std::shared_ptr<const Series>& series, const Beyond& beyond);

}  // namespace raceway::correction
