#pragma once

#include "correction/metrics.h"
#include "text/detail/json_text.h"

/// Results of corrections as JSON objects, shared by the writers of results.
namespace raceway::results {

/// `rmse_um`, `fit_percent` and the other metrics, each by its own definition.
[[nodiscard]] text::json metrics_object(const correction::Metrics& metrics);

}  // namespace raceway::results
