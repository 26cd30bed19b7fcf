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

/// Writes results as one HTML page with pictures. The page works without internet access. The page
/// contains the JSON document that `--json` prints, the values in the pictures, and the script that
/// draws the pictures (report/page/). Equal results give identical files. If a record has several
/// measured channels, the pages from the functions of this header draw only the first channel.
namespace raceway::report {

/// Returns false in a program that was built with -DRACEWAY_REPORT=OFF. All functions that return a
/// page then throw InputError.
[[nodiscard]] bool report_available();

/// Model whose friction law, parameters, oil and defaults the page shows.
struct ModelOfPage {
  std::string file;
  model::Model model;  ///< model with the parameter values that the calculation used
  std::vector<files::UsedDefault> defaults;
};

/// Returns the page that compares models with a record. The page keeps the order of the models.
/// `facts` describes the models of the page. `facts` may be empty in all functions of this header.
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

/// Operating points of a bearing, each with the predicted friction. A page draws these points in
/// addition to the curves of a friction table.
using BearingStates = std::vector<std::pair<bearing::OperatingPoint, model::FrictionPrediction>>;

/// Returns the page of a friction table. `measured` contains friction torques for comparison, or is
/// null. A measured friction torque is the sum over all bearings of the rig.
[[nodiscard]] std::string table_report(const std::string& model_file, const model::Model& model,
                                       const friction::StribeckTable& table,
                                       const BearingStates& states, const record::Record* measured,
                                       const std::vector<ModelOfPage>& facts = {},
                                       const std::vector<std::string>& warnings = {});

/// Fitted law of the shaft displacement over speed.
struct LawOfReport {
  std::optional<shaft::KinematicLawFit> fit;
  std::string statement;  ///< quality of the fit, or the reason why there is no fit
};

/// Returns the page of the shaft displacement over speed. `warnings` contains texts about unloaded
/// bearings, speeds without a result, and exceeded limits. `findings` contains the exceeded limits
/// with their values.
[[nodiscard]] std::string displacement_report(
    const std::string& model_file, const model::Model& model,
    std::span<const shaft::ShaftPoint> points, std::span<const shaft::ShaftPrediction> predictions,
    const LawOfReport& law, const std::vector<std::string>& warnings,
    const std::vector<ModelOfPage>& facts = {}, const model::Findings& findings = {});

/// Returns the HTML page that contains the report document `document`, a JSON text. The function
/// escapes `<`, `>` and `&` in the JSON text, because `</script>` would end the document too early.
[[nodiscard]] std::string report_page(const std::string& document);

}  // namespace raceway::report
