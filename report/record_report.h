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

/// Page of a record over time. The page shows measured and predicted values with the inputs below,
/// the contribution of each channel, the residual, step responses, and the error of each model or
/// effect.
namespace raceway::report {

/// A model for the pictures: a correction, or a spindle with each measured channel.
struct DrawnModel {
  std::string name{};                             ///< name for readers
  std::shared_ptr<const fit::Subject> subject{};  ///< a correction is aligned with the record
  std::vector<fit::HeldOutReading> held_out{};    ///< readings that a fit held out
  std::vector<files::UsedDefault> defaults{};     ///< defaults that the model file used
  std::vector<double> tolerances{};  ///< for a spindle: tolerance of each measured channel [SI]
};

/// Returns the page with the document that `command` prints with `--json`. Models of the same
/// channel share the readings of this channel. The page shows the eight held-out parts for the
/// first model of each channel. `facts` describe spindles. `changes` are the differences between
/// each spindle model and the next one.
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
