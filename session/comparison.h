#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fit/compare.h"
#include "io/model_file.h"
#include "io/record_report.h"
#include "io/report.h"
#include "record/record.h"
#include "session/loop_question.h"
#include "session/messages.h"
#include "session/source.h"

namespace raceway::session {

/// Models held against one record, in the order given.
struct ComparedModels {
  record::Record data{};
  std::vector<std::string> names{};                         ///< of the models, by their files
  std::vector<model::Model> models{};                       ///< as they were compared
  std::vector<std::vector<fit::Comparison>> comparisons{};  ///< of each, by measured channel
  std::vector<io::DrawnModel> drawn{};
  std::vector<io::ModelOfPage> facts{};
  std::shared_ptr<const fit::Subject> subject{};  ///< of the last

  [[nodiscard]] std::string json() const;
  /// The report, as one page.
  [[nodiscard]] std::string page() const;
};

/// Models for compare_models(), opened.
[[nodiscard]] std::vector<io::ModelFile> open_models(Messages& messages,
                                                     const std::vector<Source>& models,
                                                     const LoopOptions& options);

/// Compares them with the same rows. Those of `refit`, and what each record has for itself, are
/// fitted to the data before. The data are read by the columns and the sensor of the first model.
/// Throws io::InputError, also where a spindle is compared with something else.
[[nodiscard]] ComparedModels compare_models(Messages& messages,
                                            const std::vector<io::ModelFile>& files,
                                            const std::vector<Source>& data,
                                            const std::vector<std::string>& refit,
                                            const LoopOptions& options);

}  // namespace raceway::session
