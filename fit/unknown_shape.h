#pragma once

#include <optional>

#include "fit/candidates.h"
#include "fit/diagnose.h"

namespace raceway::fit {

/// The power law c n^a F^b ν^d that best describes what the base model misses, all its free
/// parameters refitted with it. Nothing where no fit converges.
[[nodiscard]] std::optional<Shape> find_unknown_shape(const Problem& problem,
                                                      const NoiseModel& noise,
                                                      const ResponseFit& base);

}  // namespace raceway::fit
