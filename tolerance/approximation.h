#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fit/costly_fit.h"
#include "fit/refit.h"
#include "fit/separable.h"
#include "fit/subject.h"

/// Fits spindle models and corrections: models of displacements and temperatures over time. Even
/// with additional effects, the residual of such a model is larger than the sensor noise
/// (Subject::approximates()).
namespace raceway::tolerance {

/// Record for approximate(), with means of neighbouring readings.
struct Recorded {
  std::shared_ptr<const record::Record> record{};
  std::shared_ptr<const void> prepared{};  ///< result of Subject::prepare()
  fit::Means means{};
  double duration = unset;  ///< duration of the longest run [s]
};

/// Returns the default `width` for recorded() [s]: 60 s or 1/1500 of the longest run, whichever is
/// longer.
[[nodiscard]] double usual_width(const record::Record& record);

/// Calculates the means of the readings over time intervals of `width` [s]. With a width of 0, each
/// mean consists of a single row.
[[nodiscard]] Recorded recorded(const fit::Subject& subject,
                                std::shared_ptr<const record::Record> record, double width);

/// Result of a fit of a model to the means of a record.
struct Approximation {
  std::shared_ptr<const fit::Subject> subject{};  ///< model before the fit
  std::vector<std::string> names{};               ///< names of the fitted parameters
  std::vector<record::Parameter> parameters{};    ///< the fitted parameters
  fit::SeparableFit fit{};
  /// Held-out residual of each mean, reading minus prediction [SI]; NaN for a mean that is never
  /// held out.
  std::vector<double> held_out{};
  /// RMS of the weighted residuals of all means. A residual is divided by the tolerance of its
  /// channel (fit::tolerance_of()). If the channel has no tolerance, the residual is in SI units.
  double rms = unset;
  /// RMS of the weighted held-out residuals; NaN if no part of the record can be held out.
  double rms_held_out = unset;
  /// Values of `rms` and `rms_held_out` for each channel of Subject::measured(); NaN for a channel
  /// without means.
  std::vector<double> channel_rms{}, channel_held_out{};
  /// Weight of the priors in the fit: an estimate of the variance of the weighted residuals
  /// (ApproximationErrors::variance). If the weight is 0, the fit does not use the priors.
  double prior_weight = 0.0;
  /// Parameters that stay at the values of their priors, because the record does not determine
  /// them. `names` does not contain them.
  std::vector<record::Parameter> stays{};
  /// Derivatives of the predicted means with respect to the parameters (means x parameters). Only
  /// models with slow simulations (Subject::is_costly()) have `slope` and `begin`.
  Eigen::MatrixXd slope{};
  std::shared_ptr<const fit::CostlyFit> begin{};  ///< parameters and residuals at the start values
};

struct ApproximationOptions {
  std::vector<Eigen::VectorXd> starts{};  ///< start values, in addition to Parameter::start
  int random_starts = 24;
  /// Largest number of complete fits. These fits begin at the starts with the smallest misfits.
  int polished = 3;
  bool rough = false;  ///< true: the fit of a costly model stops early with an approximate misfit
  std::function<bool()> cancelled{};  ///< no further fit starts after this function returns true
};

/// Fits the named parameters from several starts.
///
/// If some of the parameters have a prior, the first fit keeps these parameters at their priors.
/// The next fit starts from the result of the first fit and includes all parameters and priors. The
/// weight of the priors is estimated from the residuals of the previous fit
/// (Approximation::prior_weight). The fit is repeated, at most eight times, until the weight
/// changes by at most 5 %. If the record reduces the variance of a prior by less than 10 %, the
/// parameter stays at the value of the prior (Approximation::stays).
///
/// For a model with slow simulations (a costly model, see Subject::is_costly()), one fit runs from
/// Parameter::start and uses no priors.
[[nodiscard]] Approximation approximate(std::shared_ptr<const fit::Subject> subject,
                                        const Recorded& recorded,
                                        const std::vector<std::string>& names,
                                        const ApproximationOptions& options = {});

/// Returns a note which says that a parameter stays at the value of its prior.
[[nodiscard]] record::Note stays_note(const record::Parameter& parameter);

/// Throws std::invalid_argument if no start gives a prediction for every reading.
void require_fit(const Approximation& approximation);

/// Switches candidate effects on and fits the model again. The fit starts from `base`, the fit
/// without these candidates.
[[nodiscard]] Approximation approximate_with(const Approximation& base, const Recorded& recorded,
                                             const std::vector<const fit::Candidate*>& candidates,
                                             const ApproximationOptions& options = {});

/// Continues a fit that stopped early (ApproximationOptions::rough). The model must have slow
/// simulations (Subject::is_costly()).
[[nodiscard]] Approximation finished(const Approximation& rough, const Recorded& recorded);

/// Computes the held-out residuals and their RMS. The record is divided into blocks, and each block
/// is predicted from a fit to all other blocks. If the model contains a jump of the readings inside
/// the held-out block, the jump keeps its fitted time and size, because the other blocks do not
/// determine the jump. For costly models, the fit is linearised with the derivatives
/// Approximation::slope. Each simulation runs through all rows, including the rows of the held-out
/// block.
void hold_out(Approximation& approximation, const Recorded& recorded);

/// Repeats the fit on single rows instead of means, starting from `approximation`. If the record
/// has more than 20 000 rows, the fit uses means over usual_width(). `rows` receives the fitted
/// rows or means.
[[nodiscard]] Approximation refined(const Approximation& approximation, const Recorded& recorded,
                                    Recorded& rows);

/// Uncertainty of a fit.
struct ApproximationErrors {
  /// Covariance matrix of the parameters; NaN for a parameter at a bound or without influence. The
  /// matrix includes the autocorrelation of the residuals and the declared error of the model.
  Eigen::MatrixXd covariance{};
  /// Condition number of the matrix of derivatives, whose columns are scaled to length 1 [1].
  double condition = unset;
  double correlation_time = unset;  ///< correlation time of the residuals [s]
  /// Number of independent means that would determine the fit as well as all correlated means do.
  double effective = unset;
  /// Variance of the weighted residuals, multiplied by a factor for the correlation of neighbouring
  /// means.
  double variance = unset;
};
[[nodiscard]] ApproximationErrors errors_of(const Approximation& approximation,
                                            const Recorded& recorded);

/// Returns the model with the fitted parameter values.
[[nodiscard]] std::shared_ptr<const fit::Subject> fitted(const Approximation& approximation);

/// Returns the fitted model with its held-out residuals.
[[nodiscard]] fit::Refit refit_of(const Approximation& approximation, const Recorded& recorded);

}  // namespace raceway::tolerance
