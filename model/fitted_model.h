#pragma once

#include <span>
#include <vector>

#include "model/parameters.h"
#include "model/steps.h"

namespace raceway::model {

/// A model of which a fit sets numbers again and again, and the first stage that they change.
class FittedModel {
 public:
  /// `steps` of that model.
  FittedModel(Model model, const Steps& steps, std::vector<ParameterPlace> places);

  [[nodiscard]] const Model& model() const { return model_; }
  /// True where no number is ever set.
  [[nodiscard]] bool as_entered() const { return places_.empty(); }
  /// Sets the numbers, by place. Returns the first stage that differs from the last keep(). Throws
  /// std::invalid_argument for values that the model cannot take.
  [[nodiscard]] Stage set(std::span<const double> values);
  /// All predictions have these values, the last ones set.
  void keep(std::span<const double> values);

 private:
  Model model_;
  std::vector<ParameterPlace> places_;
  std::vector<Stage> stages_;  // of the places
  std::vector<double> last_;
  bool known_ = false;
};

}  // namespace raceway::model
