#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// Half the width of the 95 % band of what a model predicts, as far as it comes from the parameters
/// that were fitted:
///
///   1.96 sqrt(gᵀ C g)      g = ∂y/∂θ, C the covariance of the fit
///
/// in linear propagation, g by central differences of a tenth of a standard error to each side,
/// from the value itself where a bound or a missing balance leaves one side alone. Of these
/// parameters alone: what the model lacks and the noise of a reading are no part of it.
/// Accuracy: exact where y is linear in θ; otherwise to the square of the standard errors.
class Band {
 public:
  /// Predicted numbers, a list of the same length for every model.
  using Outputs = std::function<std::vector<double>(const Model&)>;

  static constexpr double level = 0.95;

  /// Throws std::invalid_argument for a model without a covariance.
  explicit Band(const Model& model);

  /// Names of the fitted parameters.
  [[nodiscard]] const std::vector<std::string>& fitted() const { return model_.covariance->names; }
  /// By output, in its unit; NaN where neither side has a prediction. Calls `outputs` twice for
  /// each parameter and once for the model. May be called by several threads at once.
  [[nodiscard]] std::vector<double> operator()(const Outputs& outputs) const;

 private:
  /// The model with one parameter moved to each side.
  struct Side {
    Model model;
    double step = 0.0;  ///< 0 where it cannot be moved there
  };
  Model model_;
  std::vector<Side> below_, above_;
};

}  // namespace raceway::model
