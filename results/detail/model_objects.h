#pragma once

#include "bearing/solve.h"
#include "model/model.h"
#include "model/prediction.h"
#include "results/band_of_result.h"
#include "text/detail/json_text.h"

/// Parts of a model's answers that several documents have; shared by the writers of results, not
/// for other code.
namespace raceway::results {

[[nodiscard]] text::json report_json(const bearing::SolveReport& report);

/// Level of a band and the fitted parameters behind it.
[[nodiscard]] text::json band_json(const BandOfResult& band);

/// Puts the half widths of one row of it beside the numbers of that row.
void add_band(text::json& row, const BandOfResult& band, std::size_t index);

/// Parts of a friction torque by name.
[[nodiscard]] text::json friction_json(const model::Model& model,
                                       const model::FrictionPrediction& friction);

}  // namespace raceway::results
