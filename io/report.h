#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "effects/effect.h"
#include "fit/add.h"
#include "fit/compare.h"
#include "fit/data_set.h"
#include "fit/diagnose.h"
#include "fit/fit_kinematic_law.h"
#include "fit/model.h"
#include "fit/prediction.h"
#include "fit/shaft_prediction.h"
#include "friction/stribeck_table.h"

/// Results as one HTML page with pictures that needs no network. It holds the document that
/// `--json` prints, the rows behind the pictures, and the script that draws them (io/report/). The
/// same results give the same bytes.
namespace raceway::io {

/// False in a program built with -DRACEWAY_REPORT=OFF; the functions below then throw InputError.
[[nodiscard]] bool report_available();

/// The models in the order in which they were made, as they were compared.
[[nodiscard]] std::string comparison_report(const std::vector<std::string>& model_files,
                                            const std::vector<fit::Model>& models,
                                            const std::vector<fit::Comparison>& comparisons,
                                            const fit::DataSet& data);

/// `model` is the one that was diagnosed.
[[nodiscard]] std::string diagnosis_report(const std::string& model_file, const fit::Model& model,
                                           const fit::DataSet& data,
                                           const fit::Diagnosis& diagnosis);

[[nodiscard]] std::string add_report(const std::string& model_file, const fit::DataSet& data,
                                     const fit::AddResult& result);

/// What is drawn around a bearing, beside the curves: points with their predicted balance.
using BearingStates = std::vector<std::pair<bearing::OperatingPoint, fit::FrictionPrediction>>;

/// `measured` may be null; its torque is that of all bearings of the rig.
[[nodiscard]] std::string table_report(const std::string& model_file, const fit::Model& model,
                                       const friction::StribeckTable& table,
                                       const BearingStates& states, const fit::DataSet* measured);

/// The fitted law of a shaft's displacement, or why there is none.
struct LawOfReport {
  std::optional<fit::KinematicLawFit> fit;
  std::string statement;  ///< how well it follows the curve, or why none was fitted
};

/// `warnings` are what the command says of the bearings and of speeds without balance.
[[nodiscard]] std::string displacement_report(const std::string& model_file,
                                              const fit::Model& model,
                                              std::span<const fit::ShaftPoint> points,
                                              std::span<const fit::ShaftPrediction> predictions,
                                              const LawOfReport& law,
                                              const std::vector<std::string>& warnings);

/// The page around a document: JSON as text, in which no `<` is left to end the data early.
[[nodiscard]] std::string report_page(const std::string& document);

}  // namespace raceway::io
