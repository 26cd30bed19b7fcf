#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"
#include "record/record.h"

namespace raceway::model {

/// Explains in one sentence why an effect cannot occur with the lubricant supply of the model. The
/// text is empty if the effect can occur.
[[nodiscard]] std::string ruled_out(const effects::Description& effect, const Model& model);

/// Names a change to the model that makes an effect possible, and the reason why the effect is not
/// possible now. An effect is not possible in three cases: the base law already contains the
/// effect; the bearing has cylindrical rollers, with which the effect does not occur; or the effect
/// changes the viscous moment and the base law is a friction table. The text is empty if the effect
/// is possible.
[[nodiscard]] std::string refused_by_law(const effects::Description& effect, const Model& model);

/// Returns the measured channel of a record for bearing sets on a shaft: the axial displacement, or
/// the friction torque if the record has a torque and no displacement.
[[nodiscard]] const record::Channel& measured_of_shaft(const record::Record& record);

/// Names what an effect needs and the model or the record lacks: a kind of model, a property of the
/// model or a column of the record. The text is empty if nothing is missing. missing_levels()
/// covers columns with too few different values.
[[nodiscard]] std::string missing_need(const effects::Description& effect, const Model& model,
                                       const record::Record& record);

/// Names the levels (different values of an input) that an effect needs and that the record lacks,
/// for example a second load. Without these levels, a fit can hardly distinguish the effect from a
/// change of the parameters of the base law. The text is empty if no levels are missing.
[[nodiscard]] std::string missing_levels(const effects::Description& effect, const Model& model,
                                         const record::Record& record);

}  // namespace raceway::model
