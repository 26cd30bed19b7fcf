#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// Data as entered for a row at this temperature [K], before any correction; the room is NaN if the
/// rig does not give it.
[[nodiscard]] effects::Entry entry_of(const Model& model, double temperature);

/// The model with what was found wrong in its own data put right: the oil card takes the values
/// that its effects make of it, and these leave. Corrections of what is in a record stay effects.
[[nodiscard]] Model with_corrected_data(Model model);

/// Corrections of an effect with its values, in words: "5.91 mm2/s at 100 C where 6.4 is entered";
/// empty for physics.
[[nodiscard]] std::string correction_text(const Model& model, const effects::Effect& effect);

}  // namespace raceway::model
