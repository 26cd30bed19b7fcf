#pragma once

#include "fit/whitening.h"
#include "record/units.h"

namespace raceway::fit {

/// Likelihood of readings under a fit, with normal noise of covariance S.
///
///   -2 ln L = χ² + ln det(2 π S),   χ² = eᵀ S^-1 e
///   AIC = -2 ln L + 2 k      [Akaike1974]
///   BIC = -2 ln L + k ln N   [Schwarz1978]
///
/// Compare only fits to the same readings under the same S. Readings are in SI; in a unit of f SI
/// units -2 ln L is less by 2 N ln f.
struct Likelihood {
  int readings = 0;                ///< N, of all channels together
  int parameters = 0;              ///< k, which the fit moved, those at a bound among them
  double chi_square = unset;       ///< NaN where the noise is not known [1]
  double log_determinant = unset;  ///< ln det(2 π S)
  /// -2 ln L. Where nothing but the size of the noise is unknown, with the size that makes it
  /// least; NaN where the noise was fitted in another way, or errors follow each other.
  double deviance = unset;

  [[nodiscard]] int degrees_of_freedom() const { return readings - parameters; }
  [[nodiscard]] double aic() const;
  [[nodiscard]] double bic() const;
};

/// Likelihood under known noise, of errors whose whitened squares sum up to `misfit`.
[[nodiscard]] Likelihood likelihood_of(double misfit, const Whitening& whitening, int parameters);

/// Factor by which standard errors from known noise are widened: root of the reduced χ² where the
/// misfit exceeds the noise beyond chance (1 %), else 1.
[[nodiscard]] double widening(double misfit, int degrees_of_freedom);

/// Likelihood of independent readings of equal weight, with the maximum likelihood estimate of the
/// noise variance: -2 ln L = N (1 + ln(2 π s²)), s² = Σe²/N. k does not count the noise, as usual.
[[nodiscard]] Likelihood likelihood_of_alike(double rmse, int readings, int parameters);

}  // namespace raceway::fit
