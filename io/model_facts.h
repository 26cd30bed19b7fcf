#pragma once

#include <vector>

#include "io/json_text.h"
#include "io/report.h"
#include "model/model_changes.h"

namespace raceway::io {

/// What the pages say of each model: law, its factors and those of the effects, oil, defaults.
/// Shared by the reports, not for other code.
[[nodiscard]] json model_facts(const std::vector<ModelOfPage>& models);

/// What changed from each model to the next.
[[nodiscard]] json changes_json(const std::vector<model::ModelChanges>& changes);

}  // namespace raceway::io
