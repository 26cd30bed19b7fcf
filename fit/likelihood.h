#pragma once

#include "fit/whitening.h"
#include "record/units.h"

namespace raceway::fit {

/// Likelihood L of the readings for a fit. The vector e contains the residuals. S is the covariance
/// matrix of the noise, which is normally distributed.
///
///   -2 ln L = χ² + ln det(2 π S),   χ² = eᵀ S^-1 e
///   AIC = -2 ln L + 2 k      [Akaike1974]
///   BIC = -2 ln L + k ln N   [Schwarz1978]
///
/// Compare only fits to the same readings with the same S. The value of -2 ln L depends on the unit
/// of the readings, which is the SI unit here.
struct Likelihood {
  int readings = 0;           ///< N, number of readings in all channels
  int parameters = 0;         ///< k, number of fitted parameters, including parameters at a bound
  double chi_square = unset;  ///< χ² [1]; NaN if the noise is unknown
  double log_determinant = unset;  ///< ln det(2 π S)
  /// -2 ln L [1]. If there is a single channel and its noise is unknown, the most likely size of
  /// the noise is used. The value is NaN in these cases:
  ///   - There are several channels, and the noise is unknown.
  ///   - The fit added a scatter to the declared standard deviations
  ///     (verdict::calibrate_by_noise()).
  ///   - The model is a spindle model or a correction (Subject::approximates()).
  double deviance = unset;

  [[nodiscard]] int degrees_of_freedom() const { return readings - parameters; }
  [[nodiscard]] double aic() const;
  [[nodiscard]] double bic() const;
};

/// Returns the likelihood for known noise. `misfit` is the sum of the squared whitened residuals
/// [1].
[[nodiscard]] Likelihood likelihood_of(double misfit, const Whitening& whitening, int parameters);

/// Returns the factor by which standard errors from known noise are multiplied [1]. The factor is
/// sqrt(misfit/degrees of freedom) if the misfit exceeds the noise significantly (χ² test, 1 %
/// level), otherwise 1.
[[nodiscard]] double widening(double misfit, int degrees_of_freedom);

/// Returns the likelihood of independent readings with equal weights, for the most likely variance
/// s² of the noise: -2 ln L = N (1 + ln(2 π s²)), s² = Σe²/N. s is `rmse` [SI]. s² is not counted
/// in the number of parameters k.
[[nodiscard]] Likelihood likelihood_of_alike(double rmse, int readings, int parameters);

}  // namespace raceway::fit
