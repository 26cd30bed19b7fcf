#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fit/costly_fit.h"
#include "fit/refit.h"
#include "fit/separable.h"
#include "fit/subject.h"

/// Fits models that only approximate the record (Subject::approximates()).
namespace raceway::tolerance {

/// A record prepared for the fit of such a model.
struct Recorded {
  std::shared_ptr<const record::Record> record{};
  std::shared_ptr<const void> prepared{};  ///< result of Subject::prepare()
  fit::Means means{};
  double duration = unset;  ///< duration of the longest run [s]
};

/// Returns the usual width of the means [s]: a minute or a 1500th of the longest run, whichever is
/// longer. In recorded(), a `width` of 0 keeps single rows.
[[nodiscard]] double usual_width(const record::Record& record);
[[nodiscard]] Recorded recorded(const fit::Subject& subject,
                                std::shared_ptr<const record::Record> record, double width);

/// A model with some of its parameters fitted.
struct Approximation {
  std::shared_ptr<const fit::Subject> subject{};  ///< model before the fit
  std::vector<std::string> names{};               ///< names of the fitted parameters
  std::vector<record::Parameter> parameters{};    ///< the fitted parameters
  fit::SeparableFit fit{};
  std::vector<double> held_out{};  ///< held-out error of each mean [SI]; NaN: not held out
  double rms = unset;              ///< rms error with the weights of the means
  double rms_held_out = unset;     ///< NaN if nothing can be held out
  /// `rms` and `rms_held_out` of each channel of Subject::measured(), in units of its tolerance;
  /// NaN for a channel without means.
  std::vector<double> channel_rms{}, channel_held_out{};
  /// Variance of a weighted mean, which determines the weight of priors; 0 without priors.
  double prior_weight = 0.0;
  /// Parameters that stay at their priors, because the record does not determine them. `names` does
  /// not contain them.
  std::vector<record::Parameter> stays{};
  /// Stored only for costly models: derivatives of the means with respect to the values, and the
  /// start of the fit.
  Eigen::MatrixXd slope{};
  std::shared_ptr<const fit::CostlyFit> begin{};
};

struct ApproximationOptions {
  std::vector<Eigen::VectorXd> starts{};  ///< starts in addition to the start of the subject
  int random_starts = 24;
  int polished = 3;    ///< number of best starts that are refined
  bool rough = false;  ///< true: a costly fit stops when its final misfit is known roughly
  std::function<bool()> cancelled{};
};

/// Fits the named parameters from several starts.
///
/// Parameters with a prior are fitted from the prior, after a fit of all others. The variance of
/// the means includes the autocorrelation of the residual. This variance is estimated again after
/// each fit until it changes by at most 5 %, up to eight times. If the record reduces the variance
/// of a prior by less than a tenth, the parameter stays at the prior.
[[nodiscard]] Approximation approximate(std::shared_ptr<const fit::Subject> subject,
                                        const Recorded& recorded,
                                        const std::vector<std::string>& names,
                                        const ApproximationOptions& options = {});

/// Returns the note that a parameter stays at its prior.
[[nodiscard]] record::Note stays_note(const record::Parameter& parameter);

/// Throws std::invalid_argument if no start gives a prediction for every reading.
void require_fit(const Approximation& approximation);

/// Fits a model with candidates switched on, starting from the fit without them.
[[nodiscard]] Approximation approximate_with(const Approximation& base, const Recorded& recorded,
                                             const std::vector<const fit::Candidate*>& candidates,
                                             const ApproximationOptions& options = {});

/// Continues a rough fit of a costly model to its end.
[[nodiscard]] Approximation finished(const Approximation& rough, const Recorded& recorded);

/// Computes the error on each block from a fit to all other blocks. The simulation always runs
/// through all rows.
void hold_out(Approximation& approximation, const Recorded& recorded);

/// Repeats the fit on single rows almost without a ridge, starting from the previous result. If the
/// values then diverge, the function uses the ridge. For more than 20 000 rows, it uses means
/// instead of single rows. `rows` receives the fitted data.
[[nodiscard]] Approximation refined(const Approximation& approximation, const Recorded& recorded,
                                    Recorded& rows);

/// Standard errors of all parameters. The standard errors are widened for the autocorrelation of
/// the residuals and by the declared error of the model.
struct ApproximationErrors {
  Eigen::MatrixXd covariance{};
  double condition = unset;  ///< condition number of the derivatives, columns scaled to length 1
  double correlation_time = unset;  ///< correlation time of the residuals [s]
  double effective = unset;         ///< number of effectively independent means
  /// Variance of the weighted error of a mean, including the effect of its correlated neighbours.
  double variance = unset;
};
[[nodiscard]] ApproximationErrors errors_of(const Approximation& approximation,
                                            const Recorded& recorded);

/// Returns the model with its fitted values.
[[nodiscard]] std::shared_ptr<const fit::Subject> fitted(const Approximation& approximation);

/// Returns the refit of an approximation with its held-out errors.
[[nodiscard]] fit::Refit refit_of(const Approximation& approximation, const Recorded& recorded);

}  // namespace raceway::tolerance
