#pragma once

#include <string>

#include "model/model.h"

namespace raceway::model {

/// Input that a base law needs and the model lacks, in words: a datum of the bearing, or a model
/// without an effect that belongs to its present law; empty if none.
[[nodiscard]] std::string lacks_for_law(const Model& model, friction::FrictionLaw law);

/// The model with another base law, whose numbers are the published ones and whose usual numbers
/// are free (default_free()), with the numbers of effects that were free. All else stays, but for
/// what belongs to the contact law alone: balls that traction turns are held by the outer race.
[[nodiscard]] Model with_law(Model model, friction::FrictionLaw law);

}  // namespace raceway::model
