#pragma once

#include <vector>

#include "correction/correction_subject.h"
#include "correction/range.h"

namespace raceway::correction {

/// Uncertainty of a predicted displacement [m]. Each list has one value per row of the record.
struct Band {
  std::vector<double> of_numbers{};  ///< standard error due to the fitted parameters
  /// Standard error due to the sensor resolution in the first row of each run. Temperatures are
  /// relative to this row, so their rounding error in this row shifts all predictions of the run.
  /// The record of the fit has a similar error, which is part of the fitted offset.
  std::vector<double> of_beginning{};
  double of_what_is_left = 0.0;        ///< rms of the residual, r below
  std::vector<double> extrapolated{};  ///< e below, from extrapolated()
  /// Returns the half width of the 95 % band:
  ///
  ///   1.96 sqrt(gᵀ C g + b² + r²) + e
  ///
  /// y is the predicted displacement, g is ∂y/∂θ, and C is the covariance of the parameters θ. b²
  /// is the sum over temperature sensors of (∂y/∂T1)² 2 q²/12, where T1 is the value in the first
  /// row and q is the resolution. The sum leaves out sensors for which quantum_of() finds no
  /// resolution. The factor 2 is for two records: the predicted record and the record of the fit. r
  /// is the rms of the residual on held-out parts. If no part was held out, r is the rms of the
  /// residual of the fit. e is the result of extrapolated(), the change of the prediction beyond
  /// the range of the fit.
  ///
  /// Domain:   records that start at rest. For a machine that is warm at the start, the initial
  ///           states and the offset are fitted to the record and assumed exact.
  /// Accuracy: the formula treats y as linear in the parameters. g is computed by central
  ///           differences along the principal axes of C.
  [[nodiscard]] std::vector<double> half_width() const;
};

/// Returns the band of a model. If the model has no covariance, the parameters are assumed exact.
/// If the model has no residual (`Model::left`), the term r of Band::half_width() is 0. `subject`
/// is the result of aligned() for this model and the record of `series`; `beyond` is the result of
/// beyond_range().
[[nodiscard]] Band band_of(const CorrectionSubject& subject, const Model& model,
                           const std::shared_ptr<const Series>& series, const Beyond& beyond);

}  // namespace raceway::correction
