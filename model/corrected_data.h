#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// Returns the data for a row at this temperature [K] before any correction. The ambient
/// temperature is NaN if the rig does not give it.
[[nodiscard]] effects::Entry entry_of(const Model& model, double temperature);

/// Returns the model with its own wrong data corrected: the lubricant gets the corrected values,
/// and the effects that corrected it are removed. Corrections of recorded data remain effects.
[[nodiscard]] Model with_corrected_data(Model model);

/// Describes the corrections by an effect with its values: "5.91 mm2/s at 100 C where 6.4 is
/// entered"; empty for physical effects.
[[nodiscard]] std::string correction_text(const Model& model, const effects::Effect& effect);

}  // namespace raceway::model
