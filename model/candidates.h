#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"

namespace raceway::model {

/// Returns true if a parameter of the effect is free in the model.
[[nodiscard]] bool is_free(const Model& model, std::string_view id);

/// Returns the ids of user-defined effects that have no influence yet (size zero). Such effects are
/// in the model only as candidates. Effects without a size parameter and effects with a free
/// parameter are not included.
[[nodiscard]] std::vector<std::string> waiting_effects(const Model& model);

/// Returns an effect as a candidate that `diagnose` tests; empty for an effect without a size
/// parameter. If all rotating parts of a coast-down rig contribute to the effect, the plausible
/// range of each parameter ends at the upper bound of the parameter.
[[nodiscard]] std::optional<fit::Candidate> candidate_of(const effects::Description& effect,
                                                         const Model& model);

/// Describes the measurements that would distinguish the effects in `rivals`, which explain the
/// data equally well. The result is in the order of the catalogue of effects and has no
/// repetitions.
[[nodiscard]] std::vector<std::string> settling_records(
    effects::Form form, const std::vector<std::vector<std::string>>& rivals);

}  // namespace raceway::model
