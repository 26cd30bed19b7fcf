#pragma once

#include <vector>

#include "model/model_changes.h"
#include "report/report.h"
#include "text/detail/json_text.h"

namespace raceway::report {

/// Returns facts on each model for the pages: the law with its factors, the factors of the effects,
/// oil and defaults.
[[nodiscard]] text::json model_facts(const std::vector<ModelOfPage>& models);

/// Returns the changes from each model to the next.
[[nodiscard]] text::json changes_json(const std::vector<model::ModelChanges>& changes);

}  // namespace raceway::report
