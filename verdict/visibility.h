#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Effects that the data can show, and effects that the data cannot show. The lists do not depend
/// on whether an effect is missing.
struct Visibility {
  /// Number of effects that the free parameters of the model cannot compensate. If such an effect
  /// changes the readings too little at any allowed size, it is also in `not_testable`.
  std::size_t tried = 0;
  std::vector<DetectableSize> would_have_been_found;  ///< detectable sizes of the effects
  std::vector<NotTestable> not_testable;
  /// Groups of effects that change the readings in nearly the same way.
  std::vector<std::vector<std::string>> aliases;
};

/// Calculates the detectable size of each candidate. At this size, the test for a missing effect
/// (verdict/gate.h) would detect the candidate in 99 of 100 cases. The function also calculates the
/// separable size. At this size, the data separate the candidate from the most similar other
/// effect: if the other effect replaces the candidate in the fit, -2 ln L (L: likelihood) is higher
/// by 20.
///
/// Both sizes are first calculated as if the change of the readings were proportional to the size
/// of the effect. If this detectable size is outside the range of the parameter, the function
/// searches the range without this assumption. If the function finds no detectable size, it adds
/// the effect to Visibility::not_testable. A separable size outside the range of the parameter is
/// reported as NaN.
[[nodiscard]] Visibility what_can_be_seen(const Evidence& evidence, const Attribution& attribution);

}  // namespace raceway::verdict
