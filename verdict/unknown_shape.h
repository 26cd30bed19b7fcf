#pragma once

#include <optional>

#include "verdict/diagnosis.h"
#include "verdict/evidence.h"

namespace raceway::verdict {

/// Fits a power law of the subject's formula inputs to the misfit of the base model on its first
/// channel, and refits all free parameters with it. The result is empty if the subject has no
/// formula or no fit converges.
[[nodiscard]] std::optional<fit::Shape> find_unknown_shape(const Evidence& evidence);

}  // namespace raceway::verdict
