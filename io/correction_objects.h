#pragma once

#include "correction/metrics.h"
#include "io/json_text.h"

/// Results of corrections as JSON objects, shared by the writers of results, not for other code.
namespace raceway::io {

/// `rmse_um`, `fit_percent` and the rest, by their definitions beside each other.
[[nodiscard]] json metrics_object(const correction::Metrics& metrics);

}  // namespace raceway::io
