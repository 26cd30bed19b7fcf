#pragma once

#include <vector>

#include "correction/model.h"

namespace raceway::correction {

/// Returns priors for a correction that was computed from a spindle model: for the scale of each
/// channel with a delay element, and for A, B and C of the kinematic law.
///
///   scale ± 20 %, A ± 20 %, B ± 0.1, C ± 20 %
///
/// The numbers after ± are standard deviations. They are assumptions: the computed gains depend on
/// properties of the seats and the coolant that are seldom measured. A model file may define other
/// priors.
[[nodiscard]] std::vector<NumberPrior> computed_priors(const Model& model);

}  // namespace raceway::correction
