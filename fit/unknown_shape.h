#pragma once

#include <optional>

#include "fit/diagnosis.h"
#include "fit/evidence.h"

namespace raceway::fit {

/// The power law of the subject's formula inputs that best describes what the base model misses on
/// its first channel, all its free parameters refitted with it. Nothing where the subject has no
/// formula and where no fit converges.
[[nodiscard]] std::optional<Shape> find_unknown_shape(const Evidence& evidence);

}  // namespace raceway::fit
