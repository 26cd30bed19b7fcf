#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"
#include "record/record.h"

namespace raceway::model {

/// Explains in one sentence why an effect cannot act in a model, for any data: the model has
/// another lubricant supply. The text is empty if the effect can act.
[[nodiscard]] std::string ruled_out(const effects::Description& effect, const Model& model);

/// Explains why the base law of a model excludes an effect: the law already contains it, or
/// cylindrical rollers do not have it. The text is empty if the effect is allowed.
[[nodiscard]] std::string refused_by_law(const effects::Description& effect, const Model& model);

/// Returns the channel that a record measures of the sets on a shaft: the axial displacement, or
/// the friction torque if there is no displacement.
[[nodiscard]] const record::Channel& measured_of_shaft(const record::Record& record);

/// Names the input that an effect needs and the model or the record lacks; empty if none. Missing
/// levels are not included, because the data themselves show whether base parameters act alike.
[[nodiscard]] std::string missing_need(const effects::Description& effect, const Model& model,
                                       const record::Record& record);

/// Names the levels that an effect needs and the record lacks. Without them, base parameters act
/// almost alike. The text is empty if no levels are missing.
[[nodiscard]] std::string missing_levels(const effects::Description& effect, const Model& model,
                                         const record::Record& record);

}  // namespace raceway::model
