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

/// Writes results as JSON documents with two blanks of indentation and units in the keys
/// (docs/files.md). Unknown values and values without an equilibrium are null. Numbers have 15
/// digits.
///
/// If a record has several measured channels, a document of fit results shows the first one, and
/// `channels` lists all.
namespace raceway::results {

/// Returns the document of `raceway solve --json`. `band` has one row. If `band` is null, the
/// document contains no band. `findings` appear in the member `judgement`, as in all documents with
/// findings.
[[nodiscard]] std::string solve_json(const model::Model& model,
                                     const bearing::OperatingPoint& point,
                                     const bearing::BearingEquilibrium& equilibrium,
                                     const model::FrictionPrediction& friction,
                                     const friction::HeatSplit& heat,
                                     const BandOfResult* band = nullptr,
                                     const model::Findings& findings = {});

/// Returns a table as a document. The table contains the columns of the band. `band` gives the
/// fitted parameters that cause the band; it may be null.
[[nodiscard]] std::string table_json(const model::Model& model,
                                     const friction::StribeckTable& table,
                                     const BandOfResult* band = nullptr,
                                     const model::Findings& findings = {});

/// Returns the document of a fit. `record` is the record of the fit.
[[nodiscard]] std::string calibration_json(const verdict::Calibration& calibration,
                                           const record::Record& record);

/// Returns one document for one model, and `{"models": [...]}` in the given order for several
/// models. The document contains the comparison of each measured channel for each model. For
/// corrections, it also lists the parts of the record outside the range of the fit.
[[nodiscard]] std::string comparison_json(
    const std::vector<std::string>& model_files,
    const std::vector<std::vector<verdict::Comparison>>& comparisons, const record::Record& record,
    const std::vector<correction::Beyond>& beyond = {});

/// Returns the document of a check. `defaults` of the model and `notes` on the data are texts for
/// readers.
[[nodiscard]] std::string check_json(const std::string& model_name, const loop::Check& check,
                                     const std::vector<files::UsedDefault>& defaults,
                                     const std::vector<record::Note>& notes,
                                     const correction::RecordCheck* over_time = nullptr);

/// Returns the document of a check of a model without data.
[[nodiscard]] std::string model_check_json(const std::string& model_name,
                                           const std::vector<files::UsedDefault>& defaults,
                                           const std::vector<record::Note>& notes);

/// Returns the document of an error: `{"error": {"message", "file", "line", "key"}}`, with null for
/// unknown members.
[[nodiscard]] std::string error_json(const std::string& message, const text::Place& place);

[[nodiscard]] std::string bearings_json(const std::vector<files::CatalogueBearing>& rows);

/// Returns the data of one effect, or `{"effects": [...]}` for all effects.
[[nodiscard]] std::string effect_json(const effects::Description& effect);
[[nodiscard]] std::string effects_json(std::span<const effects::Description> effects,
                                       std::span<const correction::EffectCard> of_records);

}  // namespace raceway::results
