#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// A parameter that is new, or whose value differs from the previous model.
struct ChangedNumber {
  std::string name;       ///< name as in parameters()
  std::string unit;       ///< unit in the model file
  double before = unset;  ///< NaN if the previous model lacks the parameter
  double after = unset;
};

/// Changes between two models: added and removed effects, and changed values of parameters().
/// `calibrate` and `add` make no other changes. Other differences between the models are not
/// reported.
struct ModelChanges {
  std::vector<std::string> added, removed;  ///< ids of the effects
  std::vector<ChangedNumber> numbers;       ///< in the order of parameters()
};

[[nodiscard]] ModelChanges model_changes(const Model& before, const Model& after);

/// Returns the changes from each model to the next.
[[nodiscard]] std::vector<ModelChanges> changes_between(const std::vector<Model>& models);

}  // namespace raceway::model
