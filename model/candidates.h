#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"

namespace raceway::model {

/// True if the model frees a parameter of the effect.
[[nodiscard]] bool is_free(const Model& model, std::string_view id);

/// Ids of effects of the user's own that change nothing yet, a size of zero: they stand in the
/// model only to be tried. One without a size is none of them, nor one of which something is free.
[[nodiscard]] std::vector<std::string> waiting_effects(const Model& model);

/// An effect as something that may be missing; nothing for one without a size. On the rig of a
/// coast-down what grows with the rotor has no upper end of plausibility.
[[nodiscard]] std::optional<fit::Candidate> candidate_of(const effects::Description& effect,
                                                         const Model& model);

/// Measurements that show which of some rivals is at work, as the catalogue has them for each, in
/// its order and every one once.
[[nodiscard]] std::vector<std::string> settling_records(
    effects::Form form, const std::vector<std::vector<std::string>>& rivals);

}  // namespace raceway::model
