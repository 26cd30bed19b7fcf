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
/// error. If a step in one direction is impossible, because the parameter is at its bound or the
/// model with the changed parameter has no equilibrium, the difference is one-sided. The band
/// includes neither errors from missing effects nor the noise of readings.
///
/// Accuracy: exact if y is linear in θ; otherwise the error is of the order of the squared standard
///           errors.
class Band {
 public:
  /// Function that returns predicted values of a model. Every call must return the same number of
  /// values.
  using Outputs = std::function<std::vector<double>(const Model&)>;

  static constexpr double level = 0.95;

  /// Throws std::invalid_argument if the model has no covariance or lacks a parameter that the
  /// covariance names.
  explicit Band(const Model& model);

  /// Returns the names of the fitted parameters.
  [[nodiscard]] const std::vector<std::string>& fitted() const { return model_.covariance->names; }
  /// Returns the half width of the band of each predicted value, in the unit of the value. The half
  /// width is NaN if the value or one of its derivatives cannot be computed. The operator calls
  /// `outputs` once with the model. For each fitted parameter, it calls `outputs` at most twice,
  /// with changed values of this parameter. Several threads may call the operator simultaneously.
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
