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

/// Error of one measured channel before and after a fit [SI].
struct ChannelError {
  const record::Channel* channel = nullptr;
  double rmse_before = unset, rmse_after = unset;
  int readings = 0;
};

struct Calibration {
  std::shared_ptr<const fit::Subject> subject{};  ///< with the fitted values
  std::vector<record::Parameter> parameters{};    ///< free parameters
  Eigen::MatrixXd correlation{};  ///< of the estimates, NaN where there is no standard error
  int rows = 0;                   ///< used
  std::vector<std::size_t> rows_not_predicted{};  ///< rows of the record, not used
  int degrees_of_freedom = 0;                     ///< readings minus parameters that moved
  /// χ²/degrees of freedom against the noise of the data; NaN where that is not known [1]
  double reduced_chi_square = unset;
  fit::Likelihood likelihood{};
  /// Factor by which standard errors and intervals are widened; NaN where there are none [1].
  double error_factor = unset;
  std::vector<fit::ProfileInterval> profile{};  ///< by parameter, where it was asked for
  std::vector<ChannelError> channels{};
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::not_run;
  std::vector<record::Note> messages{};  ///< for the user
  /// Held-out error [SI] and correlation time of the residuals [s], for a subject that only
  /// approximates; NaN where not known.
  double rms_held_out = unset, correlation_time = unset;

  [[nodiscard]] bool converged() const { return status == fit::FitStatus::converged; }
};

struct CalibrateOptions {
  bool profile = false;  ///< also the intervals of the parameters, Calibration::profile
};

/// Re-fits the free parameters of a subject to a record, within their bounds.
///
///   minimise |W (y - f(x))|²
///
/// with the noise by which diagnose() and add() weigh the readings as well, so that all three give
/// one parameter one value. Where the data cannot tell their noise (few rows, no scatter), declared
/// standard deviations weigh them, with a common scatter added where the misfit exceeds them
/// [PauleMandel1982]; without any all readings weigh alike. Rows that cannot be predicted are left
/// out and listed.
///
/// Standard errors follow from the linearised problem, sqrt(diag (JᵀWᵀWJ)^-1), widened by
/// sqrt(χ²/degrees of freedom) where the misfit exceeds the noise beyond chance (1 %). They do not
/// cover what a missing effect does to the values. Intervals by profile likelihood are of the same
/// noise and as wide: where -2 ln L rises by 3.84 times the square of that factor.
///
/// A parameter that the data cannot tell from those before it in the list is held at its start; all
/// of the group are marked not identifiable. So is, and held at its start too, one that the fit
/// carries to where its standard error exceeds the range of its bounds: what such a value would be
/// says nothing. Throws std::invalid_argument: a record of something else, unknown parameter, fewer
/// readings than parameters. Not of a subject that only approximates: see loop/loop.h.
[[nodiscard]] Calibration calibrate_by_noise(const fit::Subject& subject,
                                             const record::Record& record,
                                             const CalibrateOptions& options = {});

/// Covariance of the parameters with a standard error; names and values as in the calibration.
/// Empty if none has one.
[[nodiscard]] std::optional<fit::Covariance> covariance_of(const Calibration& calibration);

/// Calibration from a fit of the free parameters `response.parameters` made elsewhere: values,
/// errors, correlation. `before`: readings without the fit; `whitening`: noise of the data.
[[nodiscard]] Calibration calibration_of(std::shared_ptr<const fit::Subject> fitted,
                                         const fit::Response& response, const fit::ResponseFit& fit,
                                         const fit::Observations& observed,
                                         const Eigen::VectorXd& before,
                                         const fit::Whitening& whitening);

}  // namespace raceway::verdict
