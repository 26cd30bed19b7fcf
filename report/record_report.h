#pragma once

#include <memory>
#include <string>
#include <vector>

#include "files/used_default.h"
#include "fit/subject.h"
#include "model/model_changes.h"
#include "record/record.h"
#include "report/report.h"
#include "results/correction_results.h"
#include "verdict/add.h"
#include "verdict/compare.h"
#include "verdict/diagnosis.h"

/// Writes HTML pages of a record over time. A page shows measured and predicted values, the inputs,
/// the contribution of each channel of a correction, the residual, step responses, and the error of
/// each model or effect.
namespace raceway::report {

/// Model whose predictions the page draws: a correction, or a spindle with all measured channels.
struct DrawnModel {
  std::string name{};  ///< name on the page
  /// Model that makes the predictions; a correction must be aligned with the record
  /// (correction::aligned()).
  std::shared_ptr<const fit::Subject> subject{};
  std::vector<fit::HeldOutReading> held_out{};  ///< readings left out of a fit, and their errors
  std::vector<files::UsedDefault> defaults{};   ///< assumed values of the model
  std::vector<double> tolerances{};  ///< for a spindle: tolerance of each measured channel [SI]
};

/// Returns the HTML page for `results`, the JSON document that `command` prints with `--json`. If
/// several models predict one channel, the page contains its readings once. For the first model of
/// each channel, the page marks the parts of the record that were held out in turn. `facts` lists
/// law, oil and defaults of spindle models. `changes` contains the differences between each spindle
/// model and the next model.
[[nodiscard]] std::string record_report(const std::string& command, const std::string& results,
                                        const record::Record& record,
                                        const std::vector<DrawnModel>& models,
                                        const std::vector<ModelOfPage>& facts = {},
                                        const std::vector<model::ModelChanges>& changes = {});

[[nodiscard]] std::string record_diagnosis_report(const std::string& model_file,
                                                  const record::Record& record,
                                                  const verdict::Diagnosis& diagnosis,
                                                  const std::vector<files::UsedDefault>& defaults,
                                                  const std::vector<ModelOfPage>& facts = {});

[[nodiscard]] std::string record_add_report(const std::string& model_file,
                                            const record::Record& record,
                                            const verdict::AddResult& result,
                                            const std::vector<files::UsedDefault>& defaults,
                                            const std::vector<ModelOfPage>& facts = {});

}  // namespace raceway::report
