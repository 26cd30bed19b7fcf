#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fit/costly_fit.h"
#include "fit/refit.h"
#include "fit/separable.h"
#include "fit/subject.h"

/// Fits models of displacements and temperatures over time. Even with additional effects, the
/// residual of such a model is larger than the sensor noise (Subject::approximates()).
namespace raceway::tolerance {

/// Record with means of neighbouring readings, prepared for a fit by approximate().
struct Recorded {
  std::shared_ptr<const record::Record> record{};
  std::shared_ptr<const void> prepared{};  ///< result of Subject::prepare()
  fit::Means means{};
  double duration = unset;  ///< duration of the longest run [s]
};

/// Returns the usual duration of one mean [s]: a minute or a 1500th of the longest run, whichever
/// is longer. recorded() calculates the means; with a `width` of 0, it keeps single rows.
[[nodiscard]] double usual_width(const record::Record& record);
[[nodiscard]] Recorded recorded(const fit::Subject& subject,
                                std::shared_ptr<const record::Record> record, double width);

/// A model with some of its parameters fitted.
struct Approximation {
  std::shared_ptr<const fit::Subject> subject{};  ///< model before the fit
  std::vector<std::string> names{};               ///< names of the fitted parameters
  std::vector<record::Parameter> parameters{};    ///< the fitted parameters
  fit::SeparableFit fit{};
  /// Held-out residual of each mean, reading minus prediction [SI]; NaN: not held out.
  std::vector<double> held_out{};
  /// RMS of the weighted residuals. A residual is divided by the tolerance of its channel; if the
  /// channel has no tolerance, the residual is in SI units.
  double rms = unset;
  /// RMS of the weighted held-out residuals; NaN if no block can be held out.
  double rms_held_out = unset;
  /// `rms` and `rms_held_out` for the means of each channel of Subject::measured(); NaN for a
  /// channel without means.
  std::vector<double> channel_rms{}, channel_held_out{};
  /// Variance of the weighted residual of a mean. The fit multiplies the squared deviations of
  /// parameters from their priors by this variance, w in fit::Separable; 0: priors are not used.
  double prior_weight = 0.0;
  /// Parameters that stay at their priors, because the record does not determine them. `names` does
  /// not contain them.
  std::vector<record::Parameter> stays{};
  /// Derivatives of the predicted means with respect to the parameters, and the point at which the
  /// fit started; only for costly models (Subject::is_costly()).
  Eigen::MatrixXd slope{};
  std::shared_ptr<const fit::CostlyFit> begin{};
};

struct ApproximationOptions {
  std::vector<Eigen::VectorXd> starts{};  ///< starting values, in addition to the subject's
  int random_starts = 24;
  int polished = 3;    ///< number of best starts; a fit runs from each of them
  bool rough = false;  ///< true: a costly fit stops when its final misfit is known roughly
  std::function<bool()> cancelled{};
};

/// Fits the named parameters from several starts.
///
/// The function first fits the parameters without a prior, with all others at their priors. Then it
/// fits all parameters from this result. The variance of the fitted means takes the autocorrelation
/// of the residual into account. This variance is estimated again after each fit until it changes
/// by at most 5 %, up to eight times. If the record reduces the variance of a prior by less than a
/// tenth, the parameter stays at the prior.
[[nodiscard]] Approximation approximate(std::shared_ptr<const fit::Subject> subject,
                                        const Recorded& recorded,
                                        const std::vector<std::string>& names,
                                        const ApproximationOptions& options = {});

/// Returns the note that a parameter stays at its prior.
[[nodiscard]] record::Note stays_note(const record::Parameter& parameter);

/// Throws std::invalid_argument if no start gives a prediction for every reading.
void require_fit(const Approximation& approximation);

/// Fits a model with candidate effects switched on, starting from `base`, the fit without them.
[[nodiscard]] Approximation approximate_with(const Approximation& base, const Recorded& recorded,
                                             const std::vector<const fit::Candidate*>& candidates,
                                             const ApproximationOptions& options = {});

/// Continues a rough fit of a costly model to its end.
[[nodiscard]] Approximation finished(const Approximation& rough, const Recorded& recorded);

/// Computes the held-out residuals and their RMS: each block is predicted from a fit to all other
/// blocks. For costly models, this fit is linearised with the derivatives `slope`. Each simulation
/// runs through all rows, also through the rows of the held-out block.
void hold_out(Approximation& approximation, const Recorded& recorded);

/// Repeats the fit on individual rows instead of means, starting from `approximation`. The ridge of
/// fit::Separable is reduced from 1e-6 to 1e-12. If the parameters then diverge, the function fits
/// again with 1e-6. For more than 20 000 rows, it fits means. `rows` receives the fitted rows or
/// means.
[[nodiscard]] Approximation refined(const Approximation& approximation, const Recorded& recorded,
                                    Recorded& rows);

/// Uncertainty of a fit. The covariance matrix of the parameters is NaN for a parameter at a bound.
/// It includes the autocorrelation of the residuals and the declared error of the model.
struct ApproximationErrors {
  Eigen::MatrixXd covariance{};
  double condition = unset;  ///< condition number of the derivatives, with columns of length 1 [1]
  double correlation_time = unset;  ///< correlation time of the residuals [s]
  double effective = unset;         ///< number of effectively independent means
  /// Variance of the weighted residual of a mean, multiplied by a factor for the correlation with
  /// neighbouring means.
  double variance = unset;
};
[[nodiscard]] ApproximationErrors errors_of(const Approximation& approximation,
                                            const Recorded& recorded);

/// Returns the model with its fitted values.
[[nodiscard]] std::shared_ptr<const fit::Subject> fitted(const Approximation& approximation);

/// Returns the fitted model with its held-out residuals.
[[nodiscard]] fit::Refit refit_of(const Approximation& approximation, const Recorded& recorded);

}  // namespace raceway::tolerance
