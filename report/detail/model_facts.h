#pragma once

#include <vector>

#include "model/model_changes.h"
#include "report/report.h"
#include "text/detail/json_text.h"

namespace raceway::report {

/// What the pages say of each model: law, its factors and those of the effects, oil, defaults.
/// Shared by the reports.
[[nodiscard]] text::json model_facts(const std::vector<ModelOfPage>& models);

/// What changed from each model to the next.
[[nodiscard]] text::json changes_json(const std::vector<model::ModelChanges>& changes);

}  // namespace raceway::report
