#pragma once

#include "correction/metrics.h"
#include "record/channel.h"
#include "text/detail/json_text.h"

/// Builds JSON objects for results of corrections, for all writers in results/.
namespace raceway::results {

/// Returns `rmse_um`, `fit_percent` and the other error metrics. The unit depends on the channel:
/// `rmse_urad` for an angle, `rmse_K` for a temperature.
[[nodiscard]] text::json metrics_object(const correction::Metrics& metrics,
                                        const record::Channel& channel);

/// Returns the object with names that have the unit of the displacement. For an angle, um in the
/// names and in the values of "unit" becomes urad. Otherwise the object does not change.
[[nodiscard]] text::json in_unit_of(const record::Channel& displacement, const text::json& object);

}  // namespace raceway::results
