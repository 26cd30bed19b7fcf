#pragma once

#include <vector>

#include "model/model_changes.h"
#include "report/report.h"
#include "text/detail/json_text.h"

namespace raceway::report {

/// Returns the friction law, factors, effects, oil viscosities and defaults of each model for a
/// page.
[[nodiscard]] text::json model_facts(const std::vector<ModelOfPage>& models);

/// Returns the effects and numbers that change from each model to the next model.
[[nodiscard]] text::json changes_json(const std::vector<model::ModelChanges>& changes);

}  // namespace raceway::report
