#pragma once

#include <span>
#include <vector>

#include "model/parameters.h"
#include "model/steps.h"

namespace raceway::model {

/// Model whose parameters a fit sets repeatedly. This class finds the first stage of the prediction
/// (Stage) that the new values change.
class FittedModel {
 public:
  /// `steps` must be the steps of the model.
  FittedModel(Model model, const Steps& steps, std::vector<ParameterPlace> places);

  [[nodiscard]] const Model& model() const { return model_; }
  /// Returns true if there are no parameters to set.
  [[nodiscard]] bool as_entered() const { return places_.empty(); }
  /// Sets the parameters to `values`, in the order of `places` in the constructor. Returns the
  /// first stage whose parameters differ from the values of the last keep(). Throws
  /// std::invalid_argument for values that the model does not accept.
  [[nodiscard]] Stage set(std::span<const double> values);
  /// Call this function after all predictions were computed with these values, which must be the
  /// values of the last set().
  void keep(std::span<const double> values);

 private:
  Model model_;
  std::vector<ParameterPlace> places_;
  std::vector<Stage> stages_;  // stages of the places
  std::vector<double> last_;
  bool known_ = false;
};

}  // namespace raceway::model
