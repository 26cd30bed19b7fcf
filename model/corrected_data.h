#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// Returns the data that effects can correct: the viscosities of the oil as entered in the model,
/// and the temperatures of a row. `temperature` is the recorded temperature [K]. The room
/// temperature is NaN if the model does not give it.
[[nodiscard]] effects::Entry entry_of(const Model& model, double temperature);

/// Returns the model with corrected lubricant viscosities. The returned model does not contain the
/// effects that correct the viscosities. Effects that correct recorded values remain in the model.
[[nodiscard]] Model with_corrected_data(Model model);

/// Describes the corrected value, such as "5.91 mm2/s at 100 C instead of the entered 6.4"; empty
/// for an effect that corrects no entered or recorded value.
[[nodiscard]] std::string correction_text(const Model& model, const effects::Effect& effect);

}  // namespace raceway::model
