#pragma once

#include <optional>

#include "verdict/diagnosis.h"
#include "verdict/evidence.h"

namespace raceway::verdict {

/// Fits a power law to the misfit of the base model on its first channel, and refits all free
/// parameters together with this law. The law uses the formula inputs of the model
/// (Subject::formula()). The result is empty if the model has no formula inputs or if no fit
/// converges.
[[nodiscard]] std::optional<fit::Shape> find_unknown_shape(const Evidence& evidence);

}  // namespace raceway::verdict
