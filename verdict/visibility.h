#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Effects that these data can show and cannot show, whether or not an effect is missing.
struct Visibility {
  std::size_t tried = 0;  ///< number of effects that the free parameters of the model do not absorb
  std::vector<DetectableSize> would_have_been_found;  ///< detectable sizes of effects
  std::vector<NotTestable> not_testable;
  /// Groups of effects that change these readings in nearly the same way.
  std::vector<std::vector<std::string>> aliases;
};

/// Calculates the detectable size of each candidate. At this size, the test for a missing effect
/// (verdict/gate.h) would detect the candidate in 99 of 100 cases. The function also calculates the
/// separable size, at which a fit with the most similar other effect instead of the candidate would
/// have a -2 ln L that is higher by 20. Both sizes assume that the change of the readings is
/// proportional to the size. If the detectable size is outside the range of the parameter, the
/// function predicts the change without this assumption and looks for a detectable size within the
/// range. If there is none, the effect is in Visibility::not_testable. A separable size outside the
/// range is NaN.
[[nodiscard]] Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution);

}  // namespace raceway::verdict
