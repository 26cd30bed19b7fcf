#pragma once

#include <span>
#include <vector>

#include "model/parameters.h"
#include "model/steps.h"

namespace raceway::model {

/// Model whose parameters a fit changes many times. For each change, the class finds the first
/// stage of the prediction that must be computed again (Stage, model/steps.h).
class FittedModel {
 public:
  /// `steps` must be made from `model`. `places` are the parameters that the fit changes.
  FittedModel(Model model, const Steps& steps, std::vector<ParameterPlace> places);

  [[nodiscard]] const Model& model() const { return model_; }
  /// Returns true if the fit changes no parameters.
  [[nodiscard]] bool as_entered() const { return places_.empty(); }
  /// Sets the parameters to `values`, in the order of `places`. Returns the first stage of the
  /// prediction that must be computed again. A stage must be computed again if it depends on a
  /// parameter whose value differs from the value in the last call of keep(). Throws
  /// std::invalid_argument for values that the model does not accept.
  [[nodiscard]] Stage set(std::span<const double> values);
  /// Stores `values`, which must be the values of the last set(). Call this function after all
  /// predictions were computed with these values.
  void keep(std::span<const double> values);

 private:
  Model model_;
  std::vector<ParameterPlace> places_;
  std::vector<Stage> stages_;  // stages of the places
  std::vector<double> last_;
  bool known_ = false;
};

}  // namespace raceway::model
