#pragma once

#include <span>
#include <string>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "bearing/operating_point.h"
#include "correction/catalogue.h"
#include "correction/range.h"
#include "correction/record_check.h"
#include "effects/effect.h"
#include "files/catalogue_file.h"
#include "files/used_default.h"
#include "friction/heat.h"
#include "friction/stribeck_table.h"
#include "loop/check.h"
#include "model/judgement.h"
#include "model/model.h"
#include "model/prediction.h"
#include "record/note.h"
#include "results/band_of_result.h"
#include "text/error.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"

/// Writes results as JSON documents with an indentation of two spaces and with units in the keys
/// (docs/files.md). Unknown values, and values at operating points without equilibrium, are null.
/// Numbers have 15 significant digits.
///
/// If a record has several measured channels, the top level of a document about a fit describes the
/// first channel, and the member `channels` describes all channels.
namespace raceway::results {

/// Returns the document of `raceway solve --json` for a ball bearing. `band` contains half widths
/// of 95 % bands for this point; null means no bands. `findings` contains the limits that the
/// result exceeds; the document lists them in the member `judgement`.
[[nodiscard]] std::string solve_json(const model::Model& model,
                                     const bearing::OperatingPoint& point,
                                     const bearing::BearingEquilibrium& equilibrium,
                                     const model::FrictionPrediction& friction,
                                     const friction::HeatSplit& heat,
                                     const BandOfResult* band = nullptr,
                                     const model::Findings& findings = {});

/// Returns the document of a friction table, with one row for each operating point. If the table
/// has a 95 % band, `band` names the fitted parameters whose uncertainty gives this band; otherwise
/// it is null.
[[nodiscard]] std::string table_json(const model::Model& model,
                                     const friction::StribeckTable& table,
                                     const BandOfResult* band = nullptr,
                                     const model::Findings& findings = {});

/// Returns the document of a fit of model parameters to `record`.
[[nodiscard]] std::string calibration_json(const verdict::Calibration& calibration,
                                           const record::Record& record);

/// Returns the document that compares models with a record. The document contains the errors of
/// each model for each measured channel. For several models, the document is `{"models": [...]}` in
/// the order of `model_files`. For corrections, the document also lists the parts of the record
/// outside the range of the fit.
[[nodiscard]] std::string comparison_json(
    const std::vector<std::string>& model_files,
    const std::vector<std::vector<verdict::Comparison>>& comparisons, const record::Record& record,
    const std::vector<correction::Beyond>& beyond = {});

/// Returns the document of `raceway check` for a model and a record. `defaults` lists default
/// values of the model, and `notes` contains remarks on the record. `over_time` is the result of
/// LoopModel::over_time() for the record of a correction; null for other models.
[[nodiscard]] std::string check_json(const std::string& model_name, const loop::Check& check,
                                     const std::vector<files::UsedDefault>& defaults,
                                     const std::vector<record::Note>& notes,
                                     const correction::RecordCheck* over_time = nullptr);

/// Returns the document of `raceway check` for a model without a record.
[[nodiscard]] std::string model_check_json(const std::string& model_name,
                                           const std::vector<files::UsedDefault>& defaults,
                                           const std::vector<record::Note>& notes);

/// Returns the document of an error message: `{"error": {"message", "file", "line", "key"}}`.
/// Unknown members are null.
[[nodiscard]] std::string error_json(const std::string& message, const text::Place& place);

[[nodiscard]] std::string bearings_json(const std::vector<files::CatalogueBearing>& rows);

/// effect_json() returns the description of one effect. effects_json() returns `{"effects": [...]}`
/// with the descriptions of all given effects. `of_records` contains further effects to describe:
/// effects on a displacement over time.
[[nodiscard]] std::string effect_json(const effects::Description& effect);
[[nodiscard]] std::string effects_json(std::span<const effects::Description> effects,
                                       std::span<const correction::EffectCard> of_records);

}  // namespace raceway::results
