#pragma once

#include "correction/metrics.h"
#include "record/channel.h"
#include "text/detail/json_text.h"

/// Results of corrections as JSON objects, shared by the writers of results.
namespace raceway::results {

/// `rmse_um`, `fit_percent` and the other metrics, each by its own definition; of an angle
/// `rmse_urad` ...
[[nodiscard]] text::json metrics_object(const correction::Metrics& metrics,
                                        const record::Channel& displacement);

/// The object of a displacement that is a length, for what it is: names of an angle end in urad,
/// and so do the values of "unit".
[[nodiscard]] text::json in_unit_of(const record::Channel& displacement, const text::json& object);

}  // namespace raceway::results
