#pragma once

#include <string>

#include "model/model.h"

namespace raceway::model {

/// Names the reason why the model cannot use a base law (friction law without effects): a missing
/// or unsuitable value of the bearing, a missing friction table, or an effect that is not possible
/// with this law. The text is empty if the model can use the law.
[[nodiscard]] std::string lacks_for_law(const Model& model, friction::FrictionLaw law);

/// Returns the model with another base law. The parameters of the new law get their published
/// values. The parameters that default_free() names become free. Free parameters of effects stay
/// free. The covariance of an earlier fit is removed. If the new law is for ball bearings,
/// Palmgren's load moment is computed from the static equivalent load (F1Load::P0). If the rotation
/// of the balls was computed from the oil traction, and the new law is not the contact law, outer
/// race control replaces this computation. All other settings are unchanged.
[[nodiscard]] Model with_law(Model model, friction::FrictionLaw law);

}  // namespace raceway::model
