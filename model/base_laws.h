#pragma once

#include <string>

#include "model/model.h"

namespace raceway::model {

/// Names the reason why the model cannot use a base law: it lacks a datum of the bearing or the
/// friction table, or it has an effect that is valid only with the current law. The text is empty
/// if the model can use the law.
[[nodiscard]] std::string lacks_for_law(const Model& model, friction::FrictionLaw law);

/// Returns the model with another base law. The law starts with the published parameters. The usual
/// parameters of the law are free (default_free()). The parameters of effects stay free if they
/// were free before. Settings that belong only to the contact law are replaced: traction-controlled
/// balls become outer-race-controlled. If the new law is for ball bearings, the load in Palmgren's
/// load moment is reset to P0 (F1Load::P0). The covariance of a fit is removed. All other settings
/// are unchanged.
[[nodiscard]] Model with_law(Model model, friction::FrictionLaw law);

}  // namespace raceway::model
