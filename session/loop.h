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

/// Compares a model with measurements, finds missing effects, and calculates how much these effects
/// reduce the error of the model. The command-line program and the Python and C++ interfaces use
/// these functions. The functions accept every kind of model file.
namespace raceway::session {

/// Model, and measurements for a fit or a diagnosis of this model.
struct LoopQuestion {
  std::shared_ptr<const LoopModel> model;
  record::Record data{};
  std::shared_ptr<const fit::Subject> subject{};  ///< model prepared for a fit to the record
  Names per_record{};  ///< parameters that are fitted separately for each record

  [[nodiscard]] const std::string& source() const { return model->about().source; }
};

/// Opens the model and the measurements and sends notes to `messages`. Throws the same exceptions
/// as open_loop_model(), LoopModel::read() and LoopModel::for_fit().
[[nodiscard]] LoopQuestion ask(Messages& messages, const Source& model,
                               const std::vector<Source>& data, const LoopOptions& options);

/// These functions calibrate the model, diagnose its misfit, add effects to it, and predict the
/// readings of the record. In add(), `effects` contains the names of the effects to add, as the
/// user entered them. diagnose() and add() also fit values that the model file marks as assumed
/// (LoopModel::with_assumed_free()), and their results name these values. The functions throw the
/// same exceptions as the functions in loop/loop.h, and
/// text::InputError if the data are not suitable.
[[nodiscard]] verdict::Calibration calibrate(const LoopQuestion& asked,
                                             const verdict::CalibrateOptions& options = {});
[[nodiscard]] verdict::Diagnosis diagnose(const LoopQuestion& asked,
                                          const verdict::DiagnoseOptions& options = {});
[[nodiscard]] verdict::AddResult add(const LoopQuestion& asked, const Names& effects);
[[nodiscard]] std::vector<double> predict(const LoopQuestion& asked);

/// Returns the results as JSON or as one HTML page.
[[nodiscard]] std::string json(const LoopQuestion& asked, const verdict::Calibration& found);
[[nodiscard]] std::string json(const LoopQuestion& asked, const verdict::Diagnosis& found);
[[nodiscard]] std::string json(const LoopQuestion& asked, const verdict::AddResult& found);
[[nodiscard]] std::string page(const LoopQuestion& asked, const verdict::Diagnosis& found);
[[nodiscard]] std::string page(const LoopQuestion& asked, const verdict::AddResult& found);

/// Returns the texts of the model files with the fitted values.
[[nodiscard]] FittedTexts fitted_texts(const LoopQuestion& asked,
                                       const verdict::Calibration& found);

/// Models compared with one record, in the given order.
struct ComparedModels {
  record::Record data{};
  Names names{};  ///< file name of each model
  std::vector<ComparedModel> models{};

  /// Returns the errors of each model, one entry for each measured channel:
  /// errors()[model][channel].
  [[nodiscard]] std::vector<std::vector<verdict::Comparison>> errors() const;
  [[nodiscard]] std::string json() const;
  /// Returns the comparison as one HTML page.
  [[nodiscard]] std::string page() const;
};

/// Compares several models with the same measured rows. The data are read with the column map and
/// the sensor calibration ([torque_sensor]) of the first model. Before the comparison, the
/// parameters in CompareOptions::refit and LoopOptions::per_record are fitted to these rows. Throws
/// text::InputError if the models cannot be compared, for example a bearing and a correction.
[[nodiscard]] ComparedModels compare(Messages& messages, const std::vector<Source>& models,
                                     const std::vector<Source>& data, const CompareOptions& how,
                                     const LoopOptions& options);

/// Returns a table [columns] (TOML) that assigns the columns of a data file to channels. For a
/// model file with several corrections, the table contains the channels of all corrections.
[[nodiscard]] std::string suggested_columns(Messages& messages, const Source& model,
                                            const Source& data, LoopOptions options);

/// Results of `raceway check`: descriptions of a model and of a record, and notes.
struct CheckedModel {
  LoopModel::About model{};
  record::Record data{};
  loop::Check check{};
  /// Properties of the record that limit the quality of a correction (LoopModel::over_time());
  /// empty if the model is not a correction.
  std::optional<correction::RecordCheck> over_time{};
  std::vector<record::Note> notes{};  ///< notes on the model and the record

  [[nodiscard]] std::string json() const;
};
[[nodiscard]] CheckedModel check(Messages& messages, const Source& model, const Source& data,
                                 const LoopOptions& options);

}  // namespace raceway::session
