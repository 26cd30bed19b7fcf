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
  /// Indices of the rows without a prediction. The fit does not use these rows.
  std::vector<std::size_t> rows_not_predicted{};
  int degrees_of_freedom = 0;  ///< number of readings minus number of fitted parameters
  /// χ² divided by the degrees of freedom [1]; NaN if the noise is unknown.
  double reduced_chi_square = unset;
  fit::Likelihood likelihood{};
  /// Factor by which standard errors and intervals are multiplied [1]; NaN if there are no standard
  /// errors.
  double error_factor = unset;
  /// Profile-likelihood interval of each parameter. The interval is NaN for a parameter that was
  /// not fitted, and for all parameters if there are no standard errors. The list is empty if the
  /// intervals were not requested, or if the fit did not converge.
  std::vector<fit::ProfileInterval> profile{};
  std::vector<ChannelError> channels{};
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::not_run;
  std::vector<record::Note> messages{};  ///< messages for the user
  /// Held-out RMS error of the first measured channel [SI] and correlation time of the residuals
  /// [s], for a spindle model or a correction; NaN for other models and if unknown.
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
/// same noise as in diagnose() and add(). If the record has at most 4000 rows (most_rows_of_a_fit),
/// calibrate_by_noise(), diagnose() and add() therefore give the same value of a parameter. If the
/// data do not determine the noise (few rows, no scatter), the weights come from the declared
/// standard deviations. If the misfit then exceeds the declared standard deviations s_i, the fit
/// adds a common scatter c and uses sqrt(s_i² + c²) instead of s_i [PauleMandel1982]. If any
/// reading of a channel lacks a declared standard deviation, all readings of the channel have equal
/// weight.
///
/// Standard errors follow from the linearised problem, sqrt(diag (JᵀWᵀWJ)^-1), with J = df/dx.
/// Standard errors are multiplied by Calibration::error_factor. This factor is sqrt(χ²/degrees of
/// freedom) if the misfit significantly exceeds the noise (p < 0.01) or if the noise is unknown,
/// otherwise 1. Standard errors do not include the bias from a missing effect. Profile-likelihood
/// intervals use the noise of the fit. An interval ends where -2 ln L (L: likelihood) exceeds its
/// minimum by 3.84 times the square of Calibration::error_factor. 3.84 is the 95 % quantile of χ²
/// with one degree of freedom.
///
/// If a parameter changes the predictions in the same way as earlier parameters in the list of free
/// parameters, the fit keeps this parameter at its start value. The fit marks this parameter and
/// the earlier ones as not identifiable. The fit also keeps a parameter at its start value if its
/// standard error exceeds the range between its bounds, because the fitted value would have no
/// meaning.
///
/// Throws std::invalid_argument for a record that does not suit this kind of model, for an unknown
/// parameter, and for fewer readings than parameters. For a spindle model or a correction
/// (Subject::approximates()), use calibrate() in loop/loop.h.
[[nodiscard]] Calibration calibrate_by_noise(const fit::Subject& subject,
                                             const record::Record& record,
                                             const CalibrateOptions& options = {});

/// Returns the covariance of the parameters that have a standard error, with the names and values
/// of these parameters. The result is empty if no parameter has a standard error.
[[nodiscard]] std::optional<fit::Covariance> covariance_of(const Calibration& calibration);

/// Builds a Calibration from an existing fit. The member `parameters` of `response` contains the
/// fitted parameters. `before` contains the predictions before the fit [SI]. `whitening` describes
/// the noise of the readings.
[[nodiscard]] Calibration calibration_of(std::shared_ptr<const fit::Subject> fitted,
                                         const fit::Response& response, const fit::ResponseFit& fit,
                                         const fit::Observations& observed,
                                         const Eigen::VectorXd& before,
                                         const fit::Whitening& whitening);

}  // namespace raceway::verdict
