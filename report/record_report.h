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

/// The page of a record over time: measured and predicted values with the inputs below, the
/// contribution of each channel, the residual, step responses, and the error of each model or
/// effect.
namespace raceway::report {

/// A correction as drawn, or a spindle with each measured channel.
struct DrawnModel {
  std::string name{};                             ///< name for people
  std::shared_ptr<const fit::Subject> subject{};  ///< a correction is aligned with the record
  std::vector<fit::HeldOutReading> held_out{};    ///< readings that a fit held out
  std::vector<files::UsedDefault> defaults{};     ///< that its file used
  std::vector<double> tolerances{};               ///< for a spindle: of each measured channel [SI]
};

/// The page around the document that `command` prints with `--json`. Models of one channel share
/// its readings; the eight parts follow the first model of each channel. `facts` describe
/// spindles, `changes` the differences from each of them to the next.
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
