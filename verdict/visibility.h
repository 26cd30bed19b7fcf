#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Effects that these data could show, whether or not an effect is missing.
struct Visibility {
  std::size_t tried = 0;  ///< number of effects that can show in these readings
  std::vector<DetectableSize> would_have_been_found;  ///< detectable size of each such effect
  std::vector<NotTestable> not_testable;
  /// groups of effects that act alike on these data
  std::vector<std::vector<std::string>> aliases;
};

/// Finds detectable sizes from the scores of the candidates after projection of the base
/// parameters. At the detectable size, -2 ln L would fall by 25. At the separable size, the most
/// similar other effect would leave 20. If this size lies outside the range of the effect's own
/// parameter, the program looks for a size within the range with an equal change of the readings.
/// Without such a size, the effect could not have been found.
[[nodiscard]] Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution);

}  // namespace raceway::verdict
