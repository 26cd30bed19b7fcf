#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "io/model_file.h"
#include "io/report.h"
#include "record/record.h"
#include "session/loop_subject.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"
#include "session/tolerance.h"

namespace raceway::session {

/// What a question of the loop may ask for beside model and data.
struct LoopOptions {
  Reading reading{};
  PerRecord per_record{};
  Tolerance tolerance{};
  std::string displacement{};  ///< of a correction; refused for all else
  /// Gives the model of that place among several what no file can say; may be empty.
  std::function<void(io::ModelFile&, std::size_t)> amend{};
};

/// A model of a bearing, a shaft or a spindle with its measurements, ready for fit::diagnose(),
/// fit::calibrate() and fit::add().
struct LoopQuestion {
  io::ModelFile file;
  record::Record data;
  std::shared_ptr<const fit::Subject> model;    ///< as it is written
  std::shared_ptr<const fit::Subject> subject;  ///< as it is held against the data

  [[nodiscard]] std::vector<io::ModelOfPage> facts() const;
};

/// Opens both and says what is to be known of them. Throws io::InputError as open_model(),
/// open_records(), PerRecord and Tolerance.
[[nodiscard]] LoopQuestion ask(Messages& messages, const Source& model,
                               const std::vector<Source>& data, const LoopOptions& options);

/// The report on what was asked, as one page.
[[nodiscard]] std::string diagnosis_page(const LoopQuestion& asked,
                                         const fit::Diagnosis& diagnosis);
[[nodiscard]] std::string add_page(const LoopQuestion& asked, const fit::AddResult& result);

/// What a fit has left of its model, shared by all records where each has numbers of its own.
[[nodiscard]] const model::Model& fitted_model(const fit::Calibration& calibration);

/// Texts of the models that a fit found: one, or one for each record where records have values of
/// their own.
struct FittedTexts {
  std::vector<std::string> records;  ///< names; empty where one model holds for all
  std::vector<std::string> texts;
  /// Numbers of the covariance that stand as corrected data, for which no covariance is written.
  std::vector<std::string> corrected_data;
  /// Of every text the effects that no file can say, with their numbers.
  struct OwnEffect {
    std::string id;
    std::vector<double> values;
  };
  std::vector<std::vector<OwnEffect>> own_effects;
};
[[nodiscard]] FittedTexts fitted_texts(const io::ModelFile& file,
                                       const fit::Calibration& calibration);

/// Names of the records that have values of their own; empty where one model holds for all.
[[nodiscard]] std::vector<std::string> records_apart(const fit::Subject& subject);

}  // namespace raceway::session
