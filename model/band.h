#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// Half width of the 95 % band of a prediction, from the uncertainty of the fitted parameters:
///
///   1.96 sqrt(gᵀ C g)      g = ∂y/∂θ
///
/// y is the prediction, θ are the fitted parameters, and C is their covariance.
///
/// The propagation is linear. g comes from central differences with steps of a tenth of a standard
/// error. A difference is one-sided if a bound of the parameter or a missing equilibrium prevents
/// the step to one side. The band does not include missing effects or the noise of a reading.
/// Accuracy: exact if y is linear in θ; otherwise the error is of the order of the squared standard
///           errors.
class Band {
 public:
  /// Function that returns predicted values. Every call returns the same number of values.
  using Outputs = std::function<std::vector<double>(const Model&)>;

  static constexpr double level = 0.95;

  /// Throws std::invalid_argument for a model without a covariance.
  explicit Band(const Model& model);

  /// Returns the names of the fitted parameters.
  [[nodiscard]] const std::vector<std::string>& fitted() const { return model_.covariance->names; }
  /// Returns the half width of each output in its unit. The half width is NaN if the output is not
  /// finite for the fitted values, or if neither a decrease nor an increase of one parameter gives
  /// a finite output. The operator calls `outputs` once for the model and at most twice for each
  /// parameter. Several threads may call the operator simultaneously.
  [[nodiscard]] std::vector<double> operator()(const Outputs& outputs) const;

 private:
  /// Model in which one parameter is changed in one direction.
  struct Side {
    Model model;
    double step = 0.0;  ///< 0 if the parameter cannot change in this direction
  };
  Model model_;
  std::vector<Side> below_, above_;
};

}  // namespace raceway::model
