#pragma once

#include <string>

#include "effects/effect.h"
#include "model/model.h"
#include "record/record.h"

namespace raceway::model {

/// Why an effect cannot be at work in a model whatever data say, in a sentence: another supply of
/// lubricant. Empty if it can.
[[nodiscard]] std::string ruled_out(const effects::Description& effect, const Model& model);

/// Why the base law of a model takes no such effect, in words: it has that effect itself, or
/// cylindrical rollers have none. Empty if it does.
[[nodiscard]] std::string refused_by_law(const effects::Description& effect, const Model& model);

/// Input that an effect needs and the model or the record lacks, in words; empty if none. A need
/// for several levels is not included: the data themselves show whether base parameters act alike.
[[nodiscard]] std::string missing_need(const effects::Description& effect, const Model& model,
                                       const record::Record& record);

/// The levels an effect wants and the record does not have: without them base parameters do nearly
/// the same; empty if there is nothing.
[[nodiscard]] std::string missing_levels(const effects::Description& effect, const Model& model,
                                         const record::Record& record);

}  // namespace raceway::model
