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

/// Observations predicted from a few parameters: a black box with numeric derivatives.
///
/// Many models are affine in theirs. Where that holds to rounding at points spread within the
/// bounds, `constant + slope x` is kept and no fit needs an iteration.
struct Response {
  std::vector<Parameter> parameters{};  ///< fits begin at `start`
  /// SI, by observation; NaN where there is no prediction.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> readings{};

  /// First indices of parts that may differ in unit, and the end of the last one; empty: one part.
  std::vector<Eigen::Index> parts{};

  struct Affine {
    Eigen::VectorXd constant;
    Eigen::MatrixXd slope;
  };
  std::optional<Affine> affine{};

  [[nodiscard]] Eigen::VectorXd start() const;
  /// Predicted readings, from the affine form where there is one.
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& x) const;
  /// Derivatives of the readings (observations x parameters), by differences within the bounds.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const;
  /// Takes one-sided differences from the readings at `x`, for the way to an optimum.
  [[nodiscard]] Eigen::MatrixXd slope_beside(const Eigen::VectorXd& x,
                                             const Eigen::VectorXd& at_x) const;
  /// Finds out whether the response is affine, and keeps that form if so.
  void find_affine_form();
};

/// Observations of a subject by the values of its parameters of these names; for `prepared` see
/// Subject::predictor(). The response keeps record and `prepared`, but not the subject. Throws as
/// find_parameters().
[[nodiscard]] Response response_of(const Subject& subject, std::shared_ptr<const Record> record,
                                   const Observations& observed,
                                   const std::vector<std::string>& names,
                                   const std::shared_ptr<const void>& prepared = nullptr);

/// A response fitted to whitened readings.
struct ResponseFit {
  bool converged = false;
  int iterations = 0;  ///< over all starts
  Eigen::VectorXd values;
  Eigen::VectorXd standard_errors;  ///< of the linearised problem; NaN at a bound
  std::vector<bool> at_bound;
  Eigen::VectorXd prediction;  ///< SI
  Eigen::MatrixXd slope;       ///< derivatives of the readings (observations x parameters)
  Eigen::VectorXd residual;    ///< reading minus prediction, whitened [1]
  /// Whitened derivatives of the parameters that are not at a bound, in units of their scale.
  Eigen::MatrixXd tangent;
  double misfit = unset;  ///< |residual|², -2 ln L but for a constant [1]

  /// The parameter with its fitted value, error and bound.
  [[nodiscard]] Parameter fitted(const Response& response, std::size_t parameter) const;
};

/// Minimises |W (y - f(x))|² within the bounds. Affine responses are solved directly; others by the
/// method of Levenberg and Marquardt from each start until the best optimum is reached twice
/// (misfit within 1e-6), otherwise the fit counts as not converged.
[[nodiscard]] ResponseFit fit_response(const Response& response, const Whitening& whitening,
                                       const Eigen::VectorXd& measured,
                                       const std::vector<Eigen::VectorXd>& starts);

/// One search from one start, for fits that are ranked before a few of them are made in full: it
/// ends where a step promises less than 0.05 of the misfit, or 1e-4 of it where that is more.
/// Converged where it came so far. The response must not be affine.
[[nodiscard]] ResponseFit coarse_fit(const Response& response, const Whitening& whitening,
                                     const Eigen::VectorXd& measured, const Eigen::VectorXd& start);

}  // namespace raceway::fit
