#pragma once

#include <vector>

#include "io/json_text.h"
#include "io/report.h"

namespace raceway::io {

/// What the pages say of each model: law, its factors and those of the effects, oil, defaults.
[[nodiscard]] json model_facts(const std::vector<ModelOfPage>& models);

}  // namespace raceway::io
