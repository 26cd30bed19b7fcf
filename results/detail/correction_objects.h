#pragma once

#include "correction/metrics.h"
#include "record/channel.h"
#include "text/detail/json_text.h"

/// Builds JSON objects for results of corrections, shared by the writers of results.
namespace raceway::results {

/// Returns `rmse_um`, `fit_percent` and the other metrics, in the unit of a difference of the
/// channel: `rmse_urad` for an angle, `rmse_K` for a temperature.
[[nodiscard]] text::json metrics_object(const correction::Metrics& metrics,
                                        const record::Channel& channel);

/// Converts the names in an object from a length to the unit of the displacement. For an angle,
/// names and the values of "unit" end in urad.
[[nodiscard]] text::json in_unit_of(const record::Channel& displacement, const text::json& object);

}  // namespace raceway::results
