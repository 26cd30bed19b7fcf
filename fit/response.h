#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fit/observations.h"
#include "fit/subject.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// Observations as a function of a few parameters. The function is a black box with numerical
/// derivatives.
///
/// Many models are affine in their parameters. The program compares an affine form with the
/// predictions at points within the bounds. If both agree to rounding, `constant + slope x` is
/// stored, and fits need no iteration.
struct Response {
  std::vector<Parameter> parameters{};  ///< parameters; fits begin at their `start`
  /// Predicted observations [SI]; NaN for a missing prediction.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> readings{};

  /// First index of each part with its own unit, and the end of the last part; empty means one
  /// part.
  std::vector<Eigen::Index> parts{};

  struct Affine {
    Eigen::VectorXd constant;
    Eigen::MatrixXd slope;
  };
  std::optional<Affine> affine{};

  [[nodiscard]] Eigen::VectorXd start() const;
  /// Returns the predicted readings, from the affine form if there is one.
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& x) const;
  /// Returns the derivatives of the readings (observations x parameters) by differences within the
  /// bounds.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const;
  /// Returns the derivatives by one-sided differences; `at_x` are the readings at `x`. These
  /// derivatives are accurate enough for the steps of a search.
  [[nodiscard]] Eigen::MatrixXd slope_beside(const Eigen::VectorXd& x,
                                             const Eigen::VectorXd& at_x) const;
  /// Tests whether the response is affine, and stores the affine form if it is.
  void find_affine_form();
};

/// Returns the observations of a subject as a function of the named parameters; for `prepared` see
/// Subject::predictor(). The response stores the record and `prepared`, but not the subject. Throws
/// like find_parameters().
[[nodiscard]] Response response_of(const Subject& subject, std::shared_ptr<const Record> record,
                                   const Observations& observed,
                                   const std::vector<std::string>& names,
                                   const std::shared_ptr<const void>& prepared = nullptr);

/// A response fitted to whitened readings.
struct ResponseFit {
  bool converged = false;
  int iterations = 0;  ///< number of iterations over all starts
  Eigen::VectorXd values;
  Eigen::VectorXd standard_errors;  ///< standard errors of the linearised problem; NaN at a bound
  std::vector<bool> at_bound;
  Eigen::VectorXd prediction;  ///< SI
  Eigen::MatrixXd slope;       ///< derivatives of the readings (observations x parameters)
  Eigen::VectorXd residual;    ///< reading minus prediction, whitened [1]
  /// Whitened derivatives with respect to the parameters that are not at a bound, in units of their
  /// scale.
  Eigen::MatrixXd tangent;
  double misfit = unset;  ///< |residual|², which is -2 ln L up to a constant [1]

  /// Returns the parameter with its fitted value, its standard error and the bound that it has
  /// reached.
  [[nodiscard]] Parameter fitted(const Response& response, std::size_t parameter) const;
};

/// Minimises the sum of the squared whitened residuals within the bounds. Affine responses are
/// solved directly. Others use the method of Levenberg and Marquardt from each start, until two
/// starts reach the best optimum (relative difference of the misfit below 1e-6). If no two starts
/// agree, the fit counts as not converged.
[[nodiscard]] ResponseFit fit_response(const Response& response, const Whitening& whitening,
                                       const Eigen::VectorXd& measured,
                                       const std::vector<Eigen::VectorXd>& starts);

/// Runs one search from one start. Use this function for a first ranking of many fits, and repeat
/// the best fits in full. The search stops if the predicted fall of the misfit in the next step is
/// below 0.05, or below 1e-4 of the misfit if that is larger. A fit that stops for this reason
/// counts as converged. The response must not be affine.
[[nodiscard]] ResponseFit coarse_fit(const Response& response, const Whitening& whitening,
                                     const Eigen::VectorXd& measured, const Eigen::VectorXd& start);

}  // namespace raceway::fit
