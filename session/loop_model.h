#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "correction/range.h"
#include "correction/record_check.h"
#include "files/model_file.h"
#include "files/used_default.h"
#include "fit/subject.h"
#include "record/record.h"
#include "report/record_report.h"
#include "report/report.h"
#include "session/messages.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "session/source.h"
#include "session/tolerance.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"
#include "verdict/diagnosis.h"

namespace raceway::session {

class LoopModel;
using LoopModels = std::vector<std::unique_ptr<LoopModel>>;
using Names = std::vector<std::string>;

/// Kind of model to open from a model file.
enum class Part { any, bearing, correction };

/// Options of a calibration, diagnosis or comparison, in addition to model and record.
struct LoopOptions {
  Reading reading{};
  Names per_record{};  ///< parameters that are fitted separately for each record
  bool rows = false;   ///< true keeps each row of the record; false averages the rows of a dwell
  Tolerance tolerance{};
  /// Column name of a measured channel. If the model file contains several models, this name
  /// selects the model of this channel.
  std::string channel{};
  Part part = Part::any;
  Defaults defaults = Defaults::count;
  /// Function that changes the model of a bearing, shaft or spindle after it was read; may be
  /// empty. The second argument is the index of the model in a comparison of several models,
  /// otherwise 0.
  std::function<void(files::ModelFile&, std::size_t)> amend{};
};

/// Options for the comparison of models with a record.
struct CompareOptions {
  Names refit{};  ///< parameters that are fitted to the record before the comparison
  /// For corrections: constant error that is subtracted from the predictions of each run. "mean"
  /// subtracts the mean error of the run, "first" the error at the first reading of the run, and
  /// "none" subtracts nothing.
  std::string zero = "mean";
};

/// Model files of a fit: one file, or one for each record if parameters are fitted separately for
/// each record.
struct FittedTexts {
  Names records{};  ///< names of the records; empty if one model covers all records
  std::vector<std::string> texts{};
  /// Fitted parameters of effects that correct a value of the model file, such as the oil
  /// viscosity. The new model file contains the corrected value instead of the effect. If the list
  /// is not empty, the new model file does not contain the covariance of the fit.
  Names corrected_data{};
  /// An effect that a Python or C++ program has defined and that a model file cannot express.
  /// `values` contains the fitted parameter values of the effect.
  struct OwnEffect {
    std::string id;
    std::vector<double> values;
  };
  /// Effects that the model files cannot contain: one list for each text in `texts`.
  std::vector<std::vector<OwnEffect>> own_effects{};
};

/// A model compared with a record.
struct ComparedModel {
  std::shared_ptr<const fit::Subject> subject{};
  std::vector<verdict::Comparison> errors{};  ///< errors of each measured channel
  /// For a correction: rows with inputs outside the training data; empty for other models.
  std::optional<correction::Beyond> beyond{};
  report::DrawnModel drawn{};
  /// Description of the model for the report page; empty for a correction.
  std::optional<report::ModelOfPage> facts{};
};

/// A model file opened for the comparison with measurements: a bearing on its rig, bearing sets on
/// a shaft, a spindle, or the correction of one displacement.
class LoopModel {
 public:
  /// Description of the model file.
  struct About {
    std::string source;  ///< file name, for messages
    std::string name;
    /// Defaults and assumed values that the model uses.
    std::vector<files::UsedDefault> defaults{};
    std::vector<record::Note> notes{};
    std::vector<files::NamedFile> files{};  ///< files that the model file names
  };

  explicit LoopModel(About about) : about_(std::move(about)) {}
  virtual ~LoopModel() = default;

  [[nodiscard]] const About& about() const { return about_; }
  /// Returns the model with the parameter values of the file, without a fit, as a fit::Subject for
  /// this record.
  [[nodiscard]] virtual std::shared_ptr<const fit::Subject> as_written(
      const record::Record& data) const = 0;

  /// Reads measurements for this model and for the models in `compared_with`, and sends notes to
  /// `messages`. Several files are joined to one record. Throws text::InputError for data that
  /// cannot be read.
  [[nodiscard]] virtual record::Record read(Messages& messages, const std::vector<Source>& data,
                                            const Reading& reading,
                                            const LoopModels& compared_with = {}) const = 0;
  /// Prepares the model and the record for a fit. Notes on doubtful inputs appear as messages and
  /// in the notes of the record. Throws text::InputError if the record does not allow the fit, or
  /// if `per_record` is not valid.
  [[nodiscard]] virtual std::shared_ptr<const fit::Subject> for_fit(
      Messages& messages, record::Record& data, const Names& per_record) const = 0;
  /// Returns the model for a diagnosis or an addition of effects. `prepared` is the result of
  /// for_fit() for the same record and the same `per_record`. If the file marks a value as assumed,
  /// and the record determines this value, the value is a free parameter of the returned model.
  /// Default: returns `prepared`.
  [[nodiscard]] virtual std::shared_ptr<const fit::Subject> with_assumed_free(
      std::shared_ptr<const fit::Subject> prepared, const record::Record& data,
      const Names& per_record) const;
  /// Returns the ids of the effects in `effects`, a list of names as the user entered them. A model
  /// that is not a correction returns `effects` unchanged. Throws std::invalid_argument if a name
  /// is ambiguous.
  [[nodiscard]] virtual Names meant(const Names& effects, const record::Record& data) const = 0;

  /// Sends notes about differences between this model and `first`, the first model of a comparison,
  /// such as a different [rig]. Throws text::InputError if the two models cannot be compared.
  virtual void stand_beside(Messages& messages, const LoopModel& first) const = 0;
  /// Fits the parameters in CompareOptions::refit and `per_record` to a record, and then compares
  /// the model with this record. Throws std::invalid_argument if the record does not allow the
  /// comparison.
  [[nodiscard]] virtual ComparedModel compared(Messages& messages, const record::Record& data,
                                               const CompareOptions& how,
                                               const Names& per_record) const = 0;
  /// Returns the properties of a time record that limit the quality of this correction: sampling,
  /// noise, resolution and the range of time constants that the record can determine. The result is
  /// empty for models that are not corrections.
  [[nodiscard]] virtual std::optional<correction::RecordCheck> over_time(
      const record::Record& data) const = 0;

  /// Returns a table [columns] (TOML) that assigns the columns of a data file to channels.
  [[nodiscard]] virtual std::string suggested_columns(const Source& data) const = 0;

  /// Returns a report on the diagnosis or the added effects as one HTML page.
  [[nodiscard]] virtual std::string page(const record::Record& data,
                                         const verdict::Diagnosis& found) const = 0;
  [[nodiscard]] virtual std::string page(const record::Record& data,
                                         const verdict::AddResult& found) const = 0;
  /// Returns the texts of the model files with the fitted values.
  [[nodiscard]] virtual FittedTexts fitted_texts(const record::Record& data,
                                                 const verdict::Calibration& found) const = 0;

 private:
  About about_;
};

/// Returns the description of a model file. If the file contains several models, the description
/// covers all of them. Throws text::InputError for a file that cannot be read.
[[nodiscard]] LoopModel::About describe(Messages& messages, const Source& file,
                                        const LoopOptions& options);

/// Returns the names of the records if parameters are fitted separately for each record. The result
/// is empty if one model covers all records.
[[nodiscard]] Names records_apart(const fit::Subject& subject);

/// Fits the free parameters of `subject` to a record before a comparison. `names` are the names of
/// these parameters for the error message. Throws std::invalid_argument if the fit does not
/// converge.
[[nodiscard]] verdict::Calibration refitted(Messages& messages, const fit::Subject& subject,
                                            const record::Record& data, const Names& names);

/// Opens the model in `file` that the options select, and sends notes to `messages`. `place` is the
/// index of the model in a comparison of several models. Throws text::InputError for a file that
/// cannot be read, for an invalid tolerance, and if the file has several models and the options
/// select none.
[[nodiscard]] std::unique_ptr<LoopModel> open_loop_model(Messages& messages, const Source& file,
                                                         const LoopOptions& options,
                                                         std::size_t place = 0);

/// Opens a model as open_loop_model() does. If the file contains several corrections and no
/// bearing, and `options.channel` is empty, the function opens the first correction. Use this
/// function only for results that are the same for all corrections of the file, such as the result
/// of suggested_columns().
[[nodiscard]] std::unique_ptr<LoopModel> open_any_correction(Messages& messages, const Source& file,
                                                             LoopOptions options);

}  // namespace raceway::session
