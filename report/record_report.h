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

/// Writes HTML pages on a record over time. A page shows measured and predicted values, the inputs,
/// the contribution of each channel of a correction, the residual, step responses, and the error of
/// each model or effect.
namespace raceway::report {

/// Model whose predictions the page draws: a correction or a spindle. For a spindle, the page draws
/// all measured channels.
struct DrawnModel {
  std::string name{};  ///< name on the page
  /// Model that makes the predictions. A correction must come from correction::aligned() for this
  /// record.
  std::shared_ptr<const fit::Subject> subject{};
  std::vector<fit::HeldOutReading> held_out{};  ///< readings that a fit left out, with their errors
  std::vector<files::UsedDefault> defaults{};   ///< assumed values of the model
  std::vector<double> tolerances{};  ///< for a spindle: tolerance of each measured channel [SI]
};

/// Returns the HTML page for `results`, the JSON document that `command` prints with `--json`. If
/// several models predict the same channel, the page contains the readings of the channel once. The
/// page marks the parts of the record that were held out from a fit to calculate the held-out
/// error. If several models predict a channel, the marks are for the first model. `facts` lists
/// friction law, oil and defaults of spindle models. `changes` contains the differences between
/// each spindle model and the next model.
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
