#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// A parameter that differs from the previous model or is new.
struct ChangedNumber {
  std::string name;       ///< name as in parameters()
  std::string unit;       ///< unit as in files
  double before = unset;  ///< NaN if the previous model lacks the parameter
  double after = unset;
};

/// Changes between two models: added and removed effects, and changed values of parameters(). These
/// are all changes that `calibrate` and `add` can make. Other differences are not reported.
struct ModelChanges {
  std::vector<std::string> added, removed;  ///< ids of the effects
  std::vector<ChangedNumber> numbers;       ///< in the order of parameters()
};

[[nodiscard]] ModelChanges model_changes(const Model& before, const Model& after);

/// Returns the changes from each model to the next.
[[nodiscard]] std::vector<ModelChanges> changes_between(const std::vector<Model>& models);

}  // namespace raceway::model
