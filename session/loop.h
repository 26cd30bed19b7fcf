#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "loop/check.h"
#include "record/record.h"
#include "session/loop_model.h"
#include "session/messages.h"
#include "session/source.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/diagnose.h"

/// The loop for the command, Python and programs, whatever a model file describes: the error of a
/// model against measurements, the missing effect, the gain by adding it.
namespace raceway::session {

/// A model with its measurements, ready for a fit.
struct LoopQuestion {
  std::shared_ptr<const LoopModel> model;
  record::Record data{};
  std::shared_ptr<const fit::Subject> subject{};  ///< as prepared for the fit

  [[nodiscard]] const std::string& source() const { return model->about().source; }
};

/// Opens both and gives notes on them. Throws text::InputError as open_loop_model(),
/// LoopModel::read() and LoopModel::for_fit().
[[nodiscard]] LoopQuestion ask(Messages& messages, const Source& model,
                               const std::vector<Source>& data, const LoopOptions& options);

/// Throws as the functions of fit, and text::InputError for a question that the data do not allow.
/// `effects`: as people name them.
[[nodiscard]] verdict::Calibration calibrate(const LoopQuestion& asked,
                                             const verdict::CalibrateOptions& options = {});
[[nodiscard]] verdict::Diagnosis diagnose(const LoopQuestion& asked,
                                          const verdict::DiagnoseOptions& options = {});
[[nodiscard]] verdict::AddResult add(const LoopQuestion& asked, const Names& effects);
[[nodiscard]] std::vector<double> predict(const LoopQuestion& asked);

/// The results as JSON, and as one page.
[[nodiscard]] std::string json(const LoopQuestion& asked, const verdict::Calibration& found);
[[nodiscard]] std::string json(const LoopQuestion& asked, const verdict::Diagnosis& found);
[[nodiscard]] std::string json(const LoopQuestion& asked, const verdict::AddResult& found);
[[nodiscard]] std::string page(const LoopQuestion& asked, const verdict::Diagnosis& found);
[[nodiscard]] std::string page(const LoopQuestion& asked, const verdict::AddResult& found);

/// The texts of the models that a fit found.
[[nodiscard]] FittedTexts fitted_texts(const LoopQuestion& asked,
                                       const verdict::Calibration& found);

/// Models compared with one record, in the order given.
struct ComparedModels {
  record::Record data{};
  Names names{};  ///< of the models, by their files
  std::vector<ComparedModel> models{};

  /// Comparisons of each model, by measured channel.
  [[nodiscard]] std::vector<std::vector<verdict::Comparison>> errors() const;
  [[nodiscard]] std::string json() const;
  /// The report, as one page.
  [[nodiscard]] std::string page() const;
};

/// Compares them with the same rows, which are read by the columns and the sensor of the first.
/// What `how` names, and what each record has for itself, is fitted before. Throws
/// text::InputError, also for models of different kinds.
[[nodiscard]] ComparedModels compare(Messages& messages, const std::vector<Source>& models,
                                     const std::vector<Source>& data, const CompareOptions& how,
                                     const LoopOptions& options);

/// Suggests a table [columns] (TOML) that assigns the columns of a data file to channels; for a
/// file with several corrections, for all of them.
[[nodiscard]] std::string suggested_columns(Messages& messages, const Source& model,
                                            const Source& data, LoopOptions options);

/// Checks of a model and a record.
struct CheckedModel {
  LoopModel::About model{};
  record::Record data{};
  loop::Check check{};
  std::optional<correction::RecordCheck> over_time{};
  std::vector<record::Note> notes{};  ///< of the model and of the record

  [[nodiscard]] std::string json() const;
};
[[nodiscard]] CheckedModel check(Messages& messages, const Source& model, const Source& data,
                                 const LoopOptions& options);

}  // namespace raceway::session
