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

/// Results as JSON documents, two blanks of indent, keys with their units (docs/files.md).
/// What is not known, or has no balance, is null; numbers have 15 digits.
///
/// Where a record has several measured channels, a document of fit results shows the first, and
/// `channels` lists all.
namespace raceway::results {

/// `band`, of one row, may be null: then there is none in the document. `findings` stand in the
/// member `judgement`, as in all documents that take them.
[[nodiscard]] std::string solve_json(const model::Model& model,
                                     const bearing::OperatingPoint& point,
                                     const bearing::BearingEquilibrium& equilibrium,
                                     const model::FrictionPrediction& friction,
                                     const friction::HeatSplit& heat,
                                     const BandOfResult* band = nullptr,
                                     const model::Findings& findings = {});

/// The columns of the band stand in the table; `band` gives its parameters, and may be null.
[[nodiscard]] std::string table_json(const model::Model& model,
                                     const friction::StribeckTable& table,
                                     const BandOfResult* band = nullptr,
                                     const model::Findings& findings = {});

/// `record`: the record of the fit.
[[nodiscard]] std::string calibration_json(const verdict::Calibration& calibration,
                                           const record::Record& record);

/// One document for one model; for several `{"models": [...]}` in the order given. It has the
/// comparisons of the measured channels of each model, and for corrections the departures of the
/// record from the range of the fit.
[[nodiscard]] std::string comparison_json(
    const std::vector<std::string>& model_files,
    const std::vector<std::vector<verdict::Comparison>>& comparisons, const record::Record& record,
    const std::vector<correction::Beyond>& beyond = {});

/// `defaults` of the model and `notes` on the data, as people read them.
[[nodiscard]] std::string check_json(const std::string& model_name, const loop::Check& check,
                                     const std::vector<files::UsedDefault>& defaults,
                                     const std::vector<record::Note>& notes,
                                     const correction::RecordCheck* over_time = nullptr);

/// The document of a check of a model without data.
[[nodiscard]] std::string model_check_json(const std::string& model_name,
                                           const std::vector<files::UsedDefault>& defaults,
                                           const std::vector<record::Note>& notes);

/// The document of an error: `{"error": {"message", "file", "line", "key"}}`, null where not known.
[[nodiscard]] std::string error_json(const std::string& message, const text::Place& place);

[[nodiscard]] std::string bearings_json(const std::vector<files::CatalogueBearing>& rows);

/// The page of one effect, or `{"effects": [...]}` of all.
[[nodiscard]] std::string effect_json(const effects::Description& effect);
[[nodiscard]] std::string effects_json(std::span<const effects::Description> effects,
                                       std::span<const correction::EffectCard> of_records);

}  // namespace raceway::results
