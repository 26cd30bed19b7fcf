#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Effects that these data can show at all, whatever is missing.
struct Visibility {
  std::size_t tried = 0;  ///< effects that readings can show at all, whatever their range [1]
  std::vector<DetectableSize> would_have_been_found;  ///< effects with a detectable size
  std::vector<NotTestable> not_testable;
  std::vector<std::vector<std::string>> aliases;  ///< effects alike on these data
};

/// From the scores of the candidates with the base parameters projected off: the size at which
/// -2 ln L would fall by 25, and that at which the most alike other effect would leave 20. Where it
/// lies beyond the range of the effect's own parameter, one within is sought that changes as much;
/// an effect that has none could not have been found.
[[nodiscard]] Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution);

}  // namespace raceway::verdict
