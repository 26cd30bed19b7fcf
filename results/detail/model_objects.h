#pragma once

#include "bearing/frequencies.h"
#include "bearing/solve.h"
#include "model/bearing_life.h"
#include "model/judgement.h"
#include "model/model.h"
#include "model/prediction.h"
#include "results/band_of_result.h"
#include "text/detail/json_text.h"

/// Builds JSON objects for results of a model, for all writers in results/.
namespace raceway::results {

[[nodiscard]] text::json report_json(const bearing::SolveReport& report);

/// Returns a list of the limits that a result exceeds (docs/limits.md): `[{limit, kind, place,
/// value, allowed, unit, speed_rpm, points, text}]`; empty if it exceeds none.
[[nodiscard]] text::json judgement_json(const model::Findings& findings);

/// Returns the confidence level of a band and the names of the fitted parameters that cause it.
[[nodiscard]] text::json band_json(const BandOfResult& band);

/// Adds the half widths of the band in the row `index` to the object `row`.
void add_band(text::json& row, const BandOfResult& band, std::size_t index);

/// Adds the band of a single result to its document. If `band` is null, adds nothing.
void add_band(text::json& document, const BandOfResult* band);

/// Adds load ratings, rating lives, viscosity ratio κ and static safety of a ball or roller
/// bearing.
void add_life(text::json& document, const model::Model& model, const model::BearingLife& life);

/// Adds cage speed and bearing frequencies at a shaft speed [rad/s]. `spin` is the member name for
/// the spin frequency of a ball or roller.
void add_frequencies(text::json& document, const bearing::BearingFrequencies& turns, double speed,
                     std::string_view spin);

/// Returns the contributions to a friction torque by name [N mm].
[[nodiscard]] text::json friction_json(const model::Model& model,
                                       const model::FrictionPrediction& friction);

}  // namespace raceway::results
