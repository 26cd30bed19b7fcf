#pragma once

#include "bearing/frequencies.h"
#include "bearing/solve.h"
#include "model/bearing_life.h"
#include "model/judgement.h"
#include "model/model.h"
#include "model/prediction.h"
#include "results/band_of_result.h"
#include "text/detail/json_text.h"

/// Builds JSON objects for results of a model, shared by the writers of results.
namespace raceway::results {

[[nodiscard]] text::json report_json(const bearing::SolveReport& report);

/// Returns the limits that a result exceeds (docs/limits.md): `[{limit, kind, place, value,
/// allowed, unit, speed_rpm, points, text}]`; empty if there are none.
[[nodiscard]] text::json judgement_json(const model::Findings& findings);

/// Returns the level of a band and the names of the fitted parameters that cause it.
[[nodiscard]] text::json band_json(const BandOfResult& band);

/// Adds the half widths of one row of the band to the numbers of that row.
void add_band(text::json& row, const BandOfResult& band, std::size_t index);

/// Adds the band of a single state to its document; null if there is none.
void add_band(text::json& document, const BandOfResult* band);

/// Adds load ratings, lives, kappa and static safety. These members are the same for ball and
/// roller bearings.
void add_life(text::json& document, const model::Model& model, const model::BearingLife& life);

/// Adds the cage speed and the frequencies at a shaft speed [rad/s]. `spin` is the name for the
/// frequency of an element about its own axis.
void add_frequencies(text::json& document, const bearing::BearingFrequencies& turns, double speed,
                     std::string_view spin);

/// Returns the parts of a friction torque by name.
[[nodiscard]] text::json friction_json(const model::Model& model,
                                       const model::FrictionPrediction& friction);

}  // namespace raceway::results
