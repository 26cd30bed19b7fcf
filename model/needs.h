#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"
#include "record/record.h"

namespace raceway::model {

/// Explains in one sentence why an effect cannot occur in a model, for any record: the model has
/// another lubricant supply than the effect needs. The text is empty if the effect can occur.
[[nodiscard]] std::string ruled_out(const effects::Description& effect, const Model& model);

/// Explains why the base law of a model excludes an effect: the law already contains the effect,
/// cylindrical rollers do not have it, or it changes a part of the moment that a friction table
/// does not separate. The text is empty if the effect is allowed.
[[nodiscard]] std::string refused_by_law(const effects::Description& effect, const Model& model);

/// Returns the measured channel of a record for sets on a shaft: the axial displacement, or the
/// friction torque if the record has no displacement.
[[nodiscard]] const record::Channel& measured_of_shaft(const record::Record& record);

/// Names the input that an effect needs and that the model or the record lacks; empty if no input
/// is missing. An input with too few levels (distinct values) is not missing, because the fit shows
/// if the effect can be separated from the base parameters.
[[nodiscard]] std::string missing_need(const effects::Description& effect, const Model& model,
                                       const record::Record& record);

/// Names the levels that an effect needs and that the record lacks, for example a second load.
/// Without these levels, base parameters have almost the same influence as the effect. The text is
/// empty if no levels are missing.
[[nodiscard]] std::string missing_levels(const effects::Description& effect, const Model& model,
                                         const record::Record& record);

}  // namespace raceway::model
