#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/data_set.h"
#include "fit/model.h"
#include "fit/prediction.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// One number that a fit may move, in the unit in which files give it.
struct FitParameter {
  std::string name;
  std::string unit;
  double start = unset;
  double lower = unset, upper = unset;  ///< closed bounds
  double scale = 1.0;                   ///< typical size, > 0
};

/// Readings predicted for all rows from a few parameters: a black box with numeric derivatives.
///
/// Most models are affine in theirs (f0, z, the size of most effects). Where that holds to rounding
/// at points spread within the bounds, `constant + slope x` is kept and no fit needs an iteration.
struct Response {
  std::vector<FitParameter> parameters{};
  /// [N m] or [m] by row; NaN where there is no balance.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> readings{};

  struct Affine {
    Eigen::VectorXd constant;
    Eigen::MatrixXd slope;
  };
  std::optional<Affine> affine{};

  [[nodiscard]] Eigen::VectorXd start() const;
  /// Predicted readings, from the affine form where there is one.
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& x) const;
  /// Derivatives of the readings (rows x parameters), by differences within the bounds.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const;
  /// Finds out whether the response is affine, and keeps that form if so.
  void find_affine_form();
};

/// Readings of a model by its free parameters `names` (base law first), at every row of `data`.
/// Names as in model_parameters(). `entered`: entered_balances() of the rows, where somebody has
/// them already.
[[nodiscard]] Response model_response(const Model& model, const DataSet& data,
                                      const std::vector<std::string>& names,
                                      std::span<const Balance> entered = {});

/// A response fitted to whitened readings.
struct ResponseFit {
  bool converged = false;
  Eigen::VectorXd values;
  Eigen::VectorXd standard_errors;  ///< of the linearised problem; NaN at a bound
  std::vector<bool> at_bound;
  Eigen::VectorXd prediction;  ///< [N m] or [m]
  Eigen::MatrixXd slope;       ///< derivatives of the readings (rows x parameters)
  Eigen::VectorXd residual;    ///< reading minus prediction, whitened [1]
  /// Whitened derivatives of the parameters that are not at a bound, in units of their scale.
  Eigen::MatrixXd tangent;
  double misfit = unset;  ///< |residual|², -2 ln L but for a constant [1]
};

/// Minimises |W (y - f(x))|² within the bounds. Affine responses are solved directly; others by the
/// method of Levenberg and Marquardt from each start until the best optimum is reached twice
/// (misfit within 1e-6), otherwise the fit counts as not converged.
[[nodiscard]] ResponseFit fit_response(const Response& response, const Whitening& whitening,
                                       const Eigen::VectorXd& measured,
                                       const std::vector<Eigen::VectorXd>& starts);

}  // namespace raceway::fit
