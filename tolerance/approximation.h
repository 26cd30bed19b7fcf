#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fit/costly_fit.h"
#include "fit/refit.h"
#include "fit/separable.h"
#include "fit/subject.h"

/// Fits of subjects whose model only approximates the record (Subject::approximates()).
namespace raceway::tolerance {

/// A record as such subjects are fitted to it.
struct Recorded {
  std::shared_ptr<const record::Record> record{};
  std::shared_ptr<const void> prepared{};  ///< of the subject, see Subject::prepare()
  fit::Means means{};
  double duration = unset;  ///< [s]
};

/// Means of a minute or of a 1500th of the record, whichever is longer, but of no more than `most`
/// rows; single rows with `width` 0.
[[nodiscard]] double usual_width(const record::Record& record);
[[nodiscard]] Recorded recorded(const fit::Subject& subject,
                                std::shared_ptr<const record::Record> record, double width);

/// A subject with some of its parameters fitted.
struct Approximation {
  std::shared_ptr<const fit::Subject> subject{};  ///< as it was before the fit
  std::vector<std::string> names{};               ///< of the parameters that were fitted
  std::vector<record::Parameter> parameters{};    ///< the fitted parameters
  fit::SeparableFit fit{};
  std::vector<double> held_out{};  ///< error of each mean that its fit did not see [SI]; NaN: none
  double rms = unset;              ///< weighted as the means are
  double rms_held_out = unset;     ///< NaN where nothing can be held out
  /// Both rms of each channel of Subject::measured(), in its tolerances; NaN for one without means.
  std::vector<double> channel_rms{}, channel_held_out{};
  /// Variance of a weighted mean against which priors weigh; 0 without any.
  double prior_weight = 0.0;
  /// Left at their priors, because the record cannot tell them: of what was asked for, these are
  /// not among `names`.
  std::vector<record::Parameter> stays{};
  /// Kept of what is costly alone: derivatives of the means by the values, and where the fit began.
  Eigen::MatrixXd slope{};
  std::shared_ptr<const fit::CostlyFit> begin{};
};

struct ApproximationOptions {
  std::vector<Eigen::VectorXd> starts{};  ///< in addition to the subject's
  int random_starts = 24;
  int polished = 3;    ///< of the starts, the best
  bool rough = false;  ///< of what is costly: only far enough to see how far the misfit falls
  std::function<bool()> cancelled{};
};

/// Fits the parameters of these names from several starts.
///
/// Parameters with a prior are fitted from it, after a fit of all others. The
/// variance of the means, with what the residual remembers of itself, is found anew from each fit
/// until it settles. Where the record takes less than a tenth of the variance of a prior away, the
/// parameter stays there.
[[nodiscard]] Approximation approximate(std::shared_ptr<const fit::Subject> subject,
                                        const Recorded& recorded,
                                        const std::vector<std::string>& names,
                                        const ApproximationOptions& options = {});

/// Says that a parameter stays at its prior.
[[nodiscard]] record::Note stays_note(const record::Parameter& parameter);

/// Throws std::invalid_argument where no start has a prediction for every reading.
void require_fit(const Approximation& approximation);

/// Fits with candidates switched on, from the end of the fit without them.
[[nodiscard]] Approximation approximate_with(const Approximation& base, const Recorded& recorded,
                                             const std::vector<const fit::Candidate*>& candidates,
                                             const ApproximationOptions& options = {});

/// Goes on with a rough fit of what is costly to its end.
[[nodiscard]] Approximation finished(const Approximation& rough, const Recorded& recorded);

/// Fills in the errors on each block from a fit to all the others. The simulation runs through
/// them.
void hold_out(Approximation& approximation, const Recorded& recorded);

/// Fits an approximation to single rows (means, for very long records) without a ridge, from where
/// it ended. `rows` gets the data fitted.
[[nodiscard]] Approximation refined(const Approximation& approximation, const Recorded& recorded,
                                    Recorded& rows);

/// Standard errors of all parameters, widened for the autocorrelation of the residuals, and by the
/// model's declared error.
struct ApproximationErrors {
  Eigen::MatrixXd covariance{};
  double condition = unset;         ///< of the columns, each of unit length
  double correlation_time = unset;  ///< of the residuals [s]
  double effective = unset;         ///< number of means that count as independent
  /// Variance of the weighted error of a mean that stands for its correlated neighbours, too.
  double variance = unset;
};
[[nodiscard]] ApproximationErrors errors_of(const Approximation& approximation,
                                            const Recorded& recorded);

/// The subject with its fitted values.
[[nodiscard]] std::shared_ptr<const fit::Subject> fitted(const Approximation& approximation);

/// Refit of an approximation, with its held-out errors.
[[nodiscard]] fit::Refit refit_of(const Approximation& approximation, const Recorded& recorded);

}  // namespace raceway::tolerance
