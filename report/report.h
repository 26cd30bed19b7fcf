#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "files/used_default.h"
#include "friction/stribeck_table.h"
#include "model/judgement.h"
#include "model/model.h"
#include "model/prediction.h"
#include "record/record.h"
#include "shaft/fit_kinematic_law.h"
#include "shaft/shaft_prediction.h"
#include "verdict/add.h"
#include "verdict/compare.h"
#include "verdict/diagnosis.h"

/// Writes results as one HTML page with pictures. The page needs no network. The page contains the
/// document that `--json` prints, the data of the pictures, and the script that draws the pictures
/// (report/page/). Equal results give identical files. If there are several measured channels, the
/// page draws the first one.
namespace raceway::report {

/// Returns false in a program that was built with -DRACEWAY_REPORT=OFF. The functions below then
/// throw InputError.
[[nodiscard]] bool report_available();

/// A model whose law, factors, oil and defaults the page shows.
struct ModelOfPage {
  std::string file;
  model::Model model;  ///< the model that was used
  std::vector<files::UsedDefault> defaults;
};

/// Returns the page that compares models with a record, in the given order of the models. `facts`
/// may be empty, here and in the functions below.
[[nodiscard]] std::string comparison_report(
    const std::vector<std::string>& model_files, const std::vector<model::Model>& models,
    const std::vector<std::vector<verdict::Comparison>>& comparisons, const record::Record& record,
    const std::vector<ModelOfPage>& facts = {});

/// Returns the page of a diagnosis. `subject` is the diagnosed model.
[[nodiscard]] std::string diagnosis_report(const std::string& model_file,
                                           const fit::Subject& subject,
                                           const record::Record& record,
                                           const verdict::Diagnosis& diagnosis,
                                           const std::vector<ModelOfPage>& facts = {});

[[nodiscard]] std::string add_report(const std::string& model_file, const record::Record& record,
                                     const verdict::AddResult& result,
                                     const std::vector<ModelOfPage>& facts = {});

/// Operating points of a bearing with the predictions for them. The page draws these points in
/// addition to the curves.
using BearingStates = std::vector<std::pair<bearing::OperatingPoint, model::FrictionPrediction>>;

/// Returns the page of a table. `measured` may be null. The measured friction torque is the sum of
/// all bearings of the rig.
[[nodiscard]] std::string table_report(const std::string& model_file, const model::Model& model,
                                       const friction::StribeckTable& table,
                                       const BearingStates& states, const record::Record* measured,
                                       const std::vector<ModelOfPage>& facts = {},
                                       const std::vector<std::string>& warnings = {});

/// The fitted law of a shaft's displacement, or the reason why there is none.
struct LawOfReport {
  std::optional<shaft::KinematicLawFit> fit;
  std::string statement;  ///< quality of the fit, or the reason why there is no fit
};

/// Returns the page of displacement over speed. `warnings` are the warnings of the command about
/// bearings, speeds without equilibrium and exceeded limits. `findings` contains the exceeded
/// limits as data.
[[nodiscard]] std::string displacement_report(
    const std::string& model_file, const model::Model& model,
    std::span<const shaft::ShaftPoint> points, std::span<const shaft::ShaftPrediction> predictions,
    const LawOfReport& law, const std::vector<std::string>& warnings,
    const std::vector<ModelOfPage>& facts = {}, const model::Findings& findings = {});

/// Returns the page that contains a document. The function escapes `<`, `>` and `&` in the JSON
/// text, because `</script>` in a text would end the data too early.
[[nodiscard]] std::string report_page(const std::string& document);

}  // namespace raceway::report
