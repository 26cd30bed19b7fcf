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

/// Predicted observations (Observations) as a function of a few parameters. Derivatives are
/// numerical.
///
/// Many models are affine: linear in their parameters, plus a constant. find_affine_form() compares
/// an affine function with the predictions at several parameter values within the bounds. If
/// function and predictions agree within rounding errors, `affine` stores the function `constant +
/// slope x`, and a fit needs no iteration.
struct Response {
  /// Parameters in the order of the argument of `readings`. Parameter::start is the start value of
  /// a fit.
  std::vector<Parameter> parameters{};
  /// Predicted observations [SI]; NaN for a missing prediction.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> readings{};

  /// Index of the first observation of each channel; the last entry is the number of observations.
  /// For a single channel, the vector may be empty.
  std::vector<Eigen::Index> parts{};

  struct Affine {
    Eigen::VectorXd constant;
    Eigen::MatrixXd slope;
  };
  std::optional<Affine> affine{};

  [[nodiscard]] Eigen::VectorXd start() const;
  /// Returns the predicted observations [SI], from the affine form if there is one.
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& x) const;
  /// Returns the derivatives of the observations (observations x parameters) from two-sided
  /// differences within the bounds.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const;
  /// Returns the derivatives (observations x parameters) from one-sided differences. `at_x`
  /// contains the predicted observations at `x`. These derivatives are less accurate than
  /// jacobian(); use them only for the steps of a search.
  [[nodiscard]] Eigen::MatrixXd slope_beside(const Eigen::VectorXd& x,
                                             const Eigen::VectorXd& at_x) const;
  /// Tests whether the observations are affine in the parameters, and stores the affine form if
  /// they are.
  void find_affine_form();
};

/// Returns the predicted observations of a model as a function of the named parameters. For
/// `prepared`, see Subject::predictor(). The result shares ownership of the record and of
/// `prepared`. The result remains valid after the model is destroyed. Throws std::invalid_argument
/// in the same cases as find_parameters().
[[nodiscard]] Response response_of(const Subject& subject, std::shared_ptr<const Record> record,
                                   const Observations& observed,
                                   const std::vector<std::string>& names,
                                   const std::shared_ptr<const void>& prepared = nullptr);

/// Result of a fit of a Response to readings.
struct ResponseFit {
  bool converged = false;
  int iterations = 0;  ///< sum of the iterations from all start values
  Eigen::VectorXd values;
  /// Standard errors from the linearised problem; NaN for a parameter at a bound.
  Eigen::VectorXd standard_errors;
  std::vector<bool> at_bound;
  Eigen::VectorXd prediction;  ///< predicted observations [SI]
  Eigen::MatrixXd slope;       ///< derivatives of the observations (observations x parameters)
  Eigen::VectorXd residual;    ///< reading minus prediction, whitened [1]
  /// Whitened derivatives with respect to the parameters that are not at a bound, multiplied by
  /// Parameter::scale [1].
  Eigen::MatrixXd tangent;
  double misfit = unset;  ///< |residual|² [1]; differs from -2 ln L by a constant

  /// Returns one parameter with its fitted value, its standard error and Parameter::at_bound.
  [[nodiscard]] Parameter fitted(const Response& response, std::size_t parameter) const;
};

/// Minimises the sum of the squared whitened residuals within the bounds. An affine response is
/// solved directly. Otherwise, the method of Levenberg and Marquardt runs from one start after
/// another, until two starts reach the best minimum (relative difference of the misfit below 1e-6).
/// If no two starts reach the best minimum, ResponseFit::converged is false.
[[nodiscard]] ResponseFit fit_response(const Response& response, const Whitening& whitening,
                                       const Eigen::VectorXd& measured,
                                       const std::vector<Eigen::VectorXd>& starts);

/// Fits from one start with a coarse stopping rule. Use this function to rank many fits, and repeat
/// the best fits with fit_response(). The fit stops, marked as converged, if the predicted decrease
/// of the misfit in the next step is below 0.05 or below 1e-4 of the misfit. The response must not
/// be affine.
[[nodiscard]] ResponseFit coarse_fit(const Response& response, const Whitening& whitening,
                                     const Eigen::VectorXd& measured, const Eigen::VectorXd& start);

}  // namespace raceway::fit
