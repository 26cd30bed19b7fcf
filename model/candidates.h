#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"

namespace raceway::model {

/// Returns true if a parameter of the effect with this id is free in the model.
[[nodiscard]] bool is_free(const Model& model, std::string_view id);

/// Returns the ids of the user-defined effects that have no influence, because their parameters
/// have the values at which the effect is zero. These effects are in the model only as candidates
/// for `diagnose`. Effects with a free parameter are not included.
[[nodiscard]] std::vector<std::string> waiting_effects(const Model& model);

/// Returns an effect as a candidate that `diagnose` tests. The result is empty if the effect has no
/// size parameter (parameter with a neutral value: record::NumberCard::neutral).
[[nodiscard]] std::optional<fit::Candidate> candidate_of(const effects::Description& effect,
                                                         const Model& model);

/// Describes measurements that can distinguish between effects. Each element of `rivals` is a set
/// of effects, and all sets explain the present data equally well. The result is in the order of
/// the catalogue of effects and has no repetitions.
[[nodiscard]] std::vector<std::string> settling_records(
    effects::Form form, const std::vector<std::vector<std::string>>& rivals);

}  // namespace raceway::model
