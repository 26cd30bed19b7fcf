#pragma once

#include <string>

#include "model/model.h"

namespace raceway::model {

/// Names what prevents the model from using a base law: a missing or unsuitable value of the
/// bearing, a missing friction table, or an effect that is not possible with this law. The text is
/// empty if the model can use the law.
[[nodiscard]] std::string lacks_for_law(const Model& model, friction::FrictionLaw law);

/// Returns the model with another base law. The law starts with the published parameters. The usual
/// parameters of the law are free (default_free()). The parameters of effects stay free if they
/// were free before. Settings that belong only to the contact law are replaced: traction-controlled
/// balls become outer-race-controlled. If the new law is for ball bearings, the load in Palmgren's
/// load moment is reset to P0 (F1Load::P0). The covariance of a fit is removed. All other settings
/// are unchanged.
[[nodiscard]] Model with_law(Model model, friction::FrictionLaw law);

}  // namespace raceway::model
