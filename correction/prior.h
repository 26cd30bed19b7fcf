#pragma once

#include <vector>

#include "correction/model.h"

namespace raceway::correction {

/// Priors of the numbers that a computed spindle brings into a correction: the scale of each
/// channel with a delay element, and the law of instant displacement.
///
///   scale ± 20 %, A ± 20 %, B ± 0.1, C ± 20 %
///
/// These are assumptions: the gains of a spindle that was not fitted depend on its seats and its
/// coolant, which are seldom measured. A file may state others.
[[nodiscard]] std::vector<NumberPrior> computed_priors(const Model& model);

}  // namespace raceway::correction
