#pragma once

#include "bearing/frequencies.h"
#include "bearing/solve.h"
#include "model/bearing_life.h"
#include "model/judgement.h"
#include "model/model.h"
#include "model/prediction.h"
#include "results/band_of_result.h"
#include "text/detail/json_text.h"

/// Parts of a model's answers that several documents have; shared by the writers of results.
namespace raceway::results {

[[nodiscard]] text::json report_json(const bearing::SolveReport& report);

/// Limits that an answer passes: `[{limit, kind, place, value, allowed, unit, speed_rpm, points,
/// text}]`, docs/limits.md; empty where it passes none.
[[nodiscard]] text::json judgement_json(const model::Findings& findings);

/// Level of a band and the fitted parameters behind it.
[[nodiscard]] text::json band_json(const BandOfResult& band);

/// Adds the half widths of one row of the band to the numbers of that row.
void add_band(text::json& row, const BandOfResult& band, std::size_t index);

/// Ratings and lives, kappa and static safety, which balls and rollers have alike.
void add_life(text::json& document, const model::Model& model, const model::BearingLife& life);

/// Speed of the cage and frequencies at a shaft speed [rad/s]; `spin`: the name for the frequency
/// of an element about its own axis.
void add_frequencies(text::json& document, const bearing::BearingFrequencies& turns, double speed,
                     std::string_view spin);

/// Parts of a friction torque by name.
[[nodiscard]] text::json friction_json(const model::Model& model,
                                       const model::FrictionPrediction& friction);

}  // namespace raceway::results
