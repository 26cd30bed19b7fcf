#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// A parameter that the previous model lacks, or whose value differs from the value in the previous
/// model.
struct ChangedNumber {
  std::string name;       ///< name as in parameters()
  std::string unit;       ///< unit in the model file
  double before = unset;  ///< NaN if the previous model lacks the parameter
  double after = unset;
};

/// Changes between two models: added and removed effects, and changed values of parameters() and
/// of the oil viscosities. Other differences between the models, such as the covariance of the fit,
/// are not reported.
struct ModelChanges {
  std::vector<std::string> added, removed;  ///< ids of the effects
  /// In the order of parameters(), then the viscosities of the oil.
  std::vector<ChangedNumber> numbers;
};

[[nodiscard]] ModelChanges model_changes(const Model& before, const Model& after);

/// Returns the changes from each model to the next.
[[nodiscard]] std::vector<ModelChanges> changes_between(const std::vector<Model>& models);

}  // namespace raceway::model
