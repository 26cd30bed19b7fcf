#pragma once

#include <vector>

#include "correction/model.h"

namespace raceway::correction {

/// Returns priors (expected values with standard deviations) for a correction that was computed
/// from a spindle model. The priors apply to the scale of each channel with a delay element, and to
/// the parameters A, B and C of the kinematic law (shaft/kinematic_law.h).
///
///   scale ± 20 %, A ± 20 %, B ± 0.1, C ± 20 %
///
/// The numbers after ± are standard deviations; percentages refer to the computed values. The
/// standard deviations are assumptions, because the computed gains depend on properties of the
/// bearing seats and the coolant that are seldom measured. A model file may define other priors.
[[nodiscard]] std::vector<NumberPrior> computed_priors(const Model& model);

}  // namespace raceway::correction
