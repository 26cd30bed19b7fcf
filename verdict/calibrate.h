#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fit/covariance.h"
#include "fit/fit_status.h"
#include "fit/likelihood.h"
#include "fit/profile_interval.h"
#include "record/note.h"
#include "verdict/evidence.h"

namespace raceway::verdict {

/// RMS error of one measured channel before and after a fit [SI].
struct ChannelError {
  const record::Channel* channel = nullptr;
  double rmse_before = unset, rmse_after = unset;
  int readings = 0;
};

struct Calibration {
  std::shared_ptr<const fit::Subject> subject{};  ///< model with the fitted values
  std::vector<record::Parameter> parameters{};    ///< free parameters
  /// Correlation matrix of the free parameters; NaN for a parameter without standard error.
  Eigen::MatrixXd correlation{};
  int rows = 0;  ///< number of rows in the fit
  /// Rows without a prediction, which the fit does not use.
  std::vector<std::size_t> rows_not_predicted{};
  int degrees_of_freedom = 0;  ///< number of readings minus number of fitted parameters
  /// χ² divided by the degrees of freedom [1]; NaN if the noise is unknown.
  double reduced_chi_square = unset;
  fit::Likelihood likelihood{};
  /// Factor that multiplies standard errors and intervals [1]; NaN if there are no standard errors.
  double error_factor = unset;
  /// Profile-likelihood interval of each parameter; NaN for a parameter that was not fitted. Empty
  /// if not requested or if the fit did not converge.
  std::vector<fit::ProfileInterval> profile{};
  std::vector<ChannelError> channels{};
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::not_run;
  std::vector<record::Note> messages{};  ///< messages for the user
  /// Held-out RMS error of the first measured channel [SI] and correlation time of the residuals
  /// [s], for a model that only approximates the readings; NaN if unknown.
  double rms_held_out = unset, correlation_time = unset;

  [[nodiscard]] bool converged() const { return status == fit::FitStatus::converged; }
};

struct CalibrateOptions {
  /// If true, calibrate() also computes the profile intervals of the parameters
  /// (Calibration::profile).
  bool profile = false;
};

/// Fits the free parameters of a model to a record, within their bounds.
///
///   minimise |W (y - f(x))|²
///
/// y are the readings, and f(x) the predictions for the parameters x. The weights W come from the
/// same noise as in diagnose() and add(), so all three functions give the same value of a
/// parameter. If the data do not determine the noise (few rows, no scatter), the weights come from
/// the declared standard deviations. If the misfit exceeds these standard deviations, the fit adds
/// a common scatter to them [PauleMandel1982]. If a reading of a channel has no declared standard
/// deviation either, all readings of this channel have equal weight. Rows without a prediction are
/// listed and not used.
///
/// Standard errors follow from the linearised problem, sqrt(diag (JᵀWᵀWJ)^-1), with J = df/dx.
/// Standard errors are multiplied by sqrt(χ²/degrees of freedom) if the misfit exceeds the noise
/// significantly (1 %) or the noise is unknown. Standard errors do not include the bias from a
/// missing effect. Profile-likelihood intervals use the same noise and the same factor. The
/// intervals end where the rise of -2 ln L is 3.84 times the square of this factor.
///
/// If the data cannot separate a parameter from parameters that precede it in the list of free
/// parameters, the fit keeps the parameter at its start value. The fit marks this parameter and the
/// preceding ones as not identifiable. The fit also keeps a parameter at its start value if the
/// fitted standard error exceeds the range of the bounds, because such a fitted value has no
/// meaning. Throws std::invalid_argument for a record that does not suit this kind of model, for an
/// unknown parameter, and for fewer readings than parameters. For models that only approximate the
/// readings (Subject::approximates()), use calibrate() in loop/loop.h.
[[nodiscard]] Calibration calibrate_by_noise(const fit::Subject& subject,
                                             const record::Record& record,
                                             const CalibrateOptions& options = {});

/// Returns the covariance of the parameters that have a standard error, with the names and values
/// of these parameters. The result is empty if no parameter has a standard error.
[[nodiscard]] std::optional<fit::Covariance> covariance_of(const Calibration& calibration);

/// Builds a Calibration from an existing fit: parameter values, standard errors and correlation.
/// `response.parameters` are the fitted parameters. `before` contains the predictions before the
/// fit [SI]. `whitening` describes the noise of the readings.
[[nodiscard]] Calibration calibration_of(std::shared_ptr<const fit::Subject> fitted,
                                         const fit::Response& response, const fit::ResponseFit& fit,
                                         const fit::Observations& observed,
                                         const Eigen::VectorXd& before,
                                         const fit::Whitening& whitening);

}  // namespace raceway::verdict
