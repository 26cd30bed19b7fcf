#pragma once

#include <vector>

#include "correction/model.h"

namespace raceway::correction {

/// Returns priors for the parameters of a correction that was computed from a spindle model. The
/// parameters are the scale of each channel with a delay element and the parameters of the law of
/// the kinematic displacement.
///
///   scale ± 20 %, A ± 20 %, B ± 0.1, C ± 20 %
///
/// The widths of these priors are assumptions: the computed gains depend on data of the seats and
/// the coolant, which are seldom measured. A model file may define other priors.
[[nodiscard]] std::vector<NumberPrior> computed_priors(const Model& model);

}  // namespace raceway::correction
