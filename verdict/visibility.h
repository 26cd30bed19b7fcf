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
  std::vector<DetectableSize> would_have_been_found;  ///< detectable sizes of these effects
  std::vector<NotTestable> not_testable;
  /// Groups of effects with the same influence on these data.
  std::vector<std::vector<std::string>> aliases;
};

/// Finds detectable sizes from the scores of the candidates after the base parameters are projected
/// off. At the detectable size, the test of the gate (verdict/gate.h) would detect the effect in 99
/// of 100 cases. At the separable size, -2 ln L of the most similar other effect would be higher by
/// 20. If the detectable size is outside the range of the parameter, the program looks for a size
/// within the range that changes the readings equally. If there is no such size, the effect could
/// not have been found. A separable size outside the range is NaN.
[[nodiscard]] Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution);

}  // namespace raceway::verdict
