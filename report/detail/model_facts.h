#pragma once

#include <vector>

#include "model/model_changes.h"
#include "report/report.h"
#include "text/detail/json_text.h"

namespace raceway::report {

/// Facts on each model for the pages: law, its factors and the factors of the effects, oil,
/// defaults. Shared by the reports.
[[nodiscard]] text::json model_facts(const std::vector<ModelOfPage>& models);

/// Changes from each model to the next.
[[nodiscard]] text::json changes_json(const std::vector<model::ModelChanges>& changes);

}  // namespace raceway::report
