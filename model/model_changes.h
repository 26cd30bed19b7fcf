#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace raceway::model {

/// A number of a model that the one before it has otherwise, or has not.
struct ChangedNumber {
  std::string name;       ///< as parameters() has it
  std::string unit;       ///< as written in files
  double before = unset;  ///< NaN where it has not
  double after = unset;
};

/// Changes of effects, base law and arrangement from one model to the next: all that calibrate and
/// add write. Bearing, lubricant and rig are not compared.
struct ModelChanges {
  std::vector<std::string> added, removed;  ///< ids of effects
  std::vector<ChangedNumber> numbers;       ///< in the order of parameters()
};

[[nodiscard]] ModelChanges model_changes(const Model& before, const Model& after);

/// From each of them to the next.
[[nodiscard]] std::vector<ModelChanges> changes_between(const std::vector<Model>& models);

}  // namespace raceway::model
