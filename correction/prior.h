#pragma once

#include <vector>

#include "correction/model.h"

namespace raceway::correction {

/// Priors of the numbers that a computed spindle brings into a correction: the scale of each
/// channel with a delay element, and the law of instant displacement.
///
///   scale ± 20 %, A ± 20 %, B ± 0.1, C ± 20 %
///
/// Assumed, as no record of the machine was seen: gains of a spindle that was not fitted follow its
/// seats and coolant, which nobody has measured. The file that states them may say otherwise.
[[nodiscard]] std::vector<NumberPrior> computed_priors(const Model& model);

}  // namespace raceway::correction
