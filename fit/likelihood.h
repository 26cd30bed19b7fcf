#pragma once

#include "fit/whitening.h"
#include "record/units.h"

namespace raceway::fit {

/// Likelihood L of the readings for a fit, with the residuals e and normally distributed noise of
/// covariance S.
///
///   -2 ln L = χ² + ln det(2 π S),   χ² = eᵀ S^-1 e
///   AIC = -2 ln L + 2 k      [Akaike1974]
///   BIC = -2 ln L + k ln N   [Schwarz1978]
///
/// Compare only fits to the same readings with the same S. Readings are in SI units. If they were
/// in a unit of f SI units, -2 ln L would be smaller by 2 N ln f.
struct Likelihood {
  int readings = 0;           ///< N, number of readings in all channels
  int parameters = 0;         ///< k, number of fitted parameters, including parameters at a bound
  double chi_square = unset;  ///< χ² [1]; NaN if the noise is unknown
  double log_determinant = unset;  ///< ln det(2 π S)
  /// -2 ln L [1]. If the noise of a single channel is unknown, its most likely size is used. NaN
  /// for several channels with unknown noise, for declared standard deviations to which the fit
  /// added a scatter, and for models that only approximate the readings.
  double deviance = unset;

  [[nodiscard]] int degrees_of_freedom() const { return readings - parameters; }
  [[nodiscard]] double aic() const;
  [[nodiscard]] double bic() const;
};

/// Returns the likelihood for known noise. `misfit` is the sum of the squared whitened residuals
/// [1].
[[nodiscard]] Likelihood likelihood_of(double misfit, const Whitening& whitening, int parameters);

/// Returns the factor for standard errors from known noise [1]: sqrt(misfit/degrees of freedom) if
/// the misfit exceeds the noise significantly (1 %), otherwise 1.
[[nodiscard]] double widening(double misfit, int degrees_of_freedom);

/// Returns the likelihood of independent readings with equal weights and the most likely noise
/// variance: -2 ln L = N (1 + ln(2 π s²)), s² = Σe²/N. s is `rmse` [SI], and k does not include the
/// variance of the noise.
[[nodiscard]] Likelihood likelihood_of_alike(double rmse, int readings, int parameters);

}  // namespace raceway::fit
