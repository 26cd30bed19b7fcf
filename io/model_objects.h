#pragma once

#include "bearing/solve.h"
#include "io/band_of_result.h"
#include "io/json_text.h"
#include "model/model.h"
#include "model/prediction.h"

/// Parts of a model's answers that several documents have; shared by the writers of results, not
/// for other code.
namespace raceway::io {

[[nodiscard]] json report_json(const bearing::SolveReport& report);

/// Level of a band and the fitted parameters behind it.
[[nodiscard]] json band_json(const BandOfResult& band);

/// Puts the half widths of one row of it beside the numbers of that row.
void add_band(json& row, const BandOfResult& band, std::size_t index);

/// Parts of a friction torque by name.
[[nodiscard]] json friction_json(const model::Model& model,
                                 const model::FrictionPrediction& friction);

}  // namespace raceway::io
