#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"

namespace raceway::model {

/// Returns the viscosities of the oil and the temperatures of a row before any correction.
/// `temperature` is the recorded temperature [K]. The ambient temperature is NaN if the rig does
/// not give it.
[[nodiscard]] effects::Entry entry_of(const Model& model, double temperature);

/// Returns the model with corrected lubricant viscosities. Effects that correct these viscosities
/// are removed, because the lubricant then has the corrected values. Effects that correct recorded
/// values remain.
[[nodiscard]] Model with_corrected_data(Model model);

/// Describes the value that an effect corrects, such as "5.91 mm2/s at 100 C instead of the entered
/// 6.4"; empty for physical effects.
[[nodiscard]] std::string correction_text(const Model& model, const effects::Effect& effect);

}  // namespace raceway::model
