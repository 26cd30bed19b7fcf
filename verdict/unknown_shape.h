#pragma once

#include <optional>

#include "verdict/diagnosis.h"
#include "verdict/evidence.h"

namespace raceway::verdict {

/// The power law of the subject's formula inputs that best describes what the base model misses on
/// its first channel, all its free parameters refitted with it. Nothing where the subject has no
/// formula and where no fit converges.
[[nodiscard]] std::optional<fit::Shape> find_unknown_shape(const Evidence& evidence);

}  // namespace raceway::verdict
