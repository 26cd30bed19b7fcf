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

/// Part of a file.
enum class Part { any, bearing, correction };

/// Options of a question in addition to models and data.
struct LoopOptions {
  Reading reading{};
  Names per_record{};  ///< parameters that each of several records has for itself
  bool rows = false;   ///< rows of a logger stay apart, where dwells would be averaged
  Tolerance tolerance{};
  /// For a file with several parts: a column that the wanted part predicts.
  std::string channel{};
  Part part = Part::any;
  Defaults defaults = Defaults::count;
  /// Changes the model of that place among several beyond its file; may be empty.
  std::function<void(files::ModelFile&, std::size_t)> amend{};
};

/// Options for comparing models with a record.
struct CompareOptions {
  Names refit{};  ///< parameters that are fitted to it before
  /// The constant that is subtracted from each run of a correction: "mean", "first" or "none".
  std::string zero = "mean";
};

/// Texts of the models that a fit found: one, or one for each record where records have values of
/// their own.
struct FittedTexts {
  Names records{};  ///< empty where one model holds for all
  std::vector<std::string> texts{};
  /// Numbers of the covariance that stand as corrected data, for which no covariance is written.
  Names corrected_data{};
  /// Effects of every text that no file can express, with their numbers.
  struct OwnEffect {
    std::string id;
    std::vector<double> values;
  };
  std::vector<std::vector<OwnEffect>> own_effects{};
};

/// A model compared with a record.
struct ComparedModel {
  std::shared_ptr<const fit::Subject> subject{};
  std::vector<verdict::Comparison> errors{};   ///< by measured channel
  std::optional<correction::Beyond> beyond{};  ///< of a correction: what its numbers never saw
  report::DrawnModel drawn{};
  std::optional<report::ModelOfPage> facts{};  ///< of all else
};

/// Contents of a file, opened for the loop: a bearing on its rig, the sets on a shaft, a spindle,
/// or the correction of one displacement.
class LoopModel {
 public:
  /// Description of the file.
  struct About {
    std::string source;  ///< file name, for messages
    std::string name;
    std::vector<files::UsedDefault> defaults{};  ///< that were used
    std::vector<record::Note> notes{};
    std::vector<files::NamedFile> files{};  ///< that it names
  };

  explicit LoopModel(About about) : about_(std::move(about)) {}
  virtual ~LoopModel() = default;

  [[nodiscard]] const About& about() const { return about_; }
  [[nodiscard]] virtual std::shared_ptr<const fit::Subject> as_written() const = 0;

  /// Reads measurements of it and of the models that it is compared with, and gives notes on them.
  /// Several files are joined to one record. Throws text::InputError.
  [[nodiscard]] virtual record::Record read(Messages& messages, const std::vector<Source>& data,
                                            const Reading& reading,
                                            const LoopModels& compared_with = {}) const = 0;
  /// The subject as a fit takes it. Doubts about its inputs are messages and stand in the notes of
  /// the record. Throws text::InputError for a fit that the record does not allow, and for
  /// `per_record`.
  [[nodiscard]] virtual std::shared_ptr<const fit::Subject> for_fit(
      Messages& messages, record::Record& data, const Names& per_record) const = 0;
  /// The effects that a person means by these names. Throws std::invalid_argument where one name
  /// means several.
  [[nodiscard]] virtual Names meant(const Names& effects, const record::Record& data) const = 0;

  /// Adds notes for a comparison with the first of several models. Throws text::InputError where
  /// they cannot be compared.
  virtual void stand_beside(Messages& messages, const LoopModel& first) const = 0;
  /// Compares it with a record, after a fit of the parameters that `how` and `per_record` name.
  /// Throws std::invalid_argument for a comparison that the record does not allow.
  [[nodiscard]] virtual ComparedModel compared(Messages& messages, const record::Record& data,
                                               const CompareOptions& how,
                                               const Names& per_record) const = 0;
  /// Checks of a record over time for it; none where its rows are no time series.
  [[nodiscard]] virtual std::optional<correction::RecordCheck> over_time(
      const record::Record& data) const = 0;

  /// Suggests a table [columns] that assigns the columns of a data file to channels.
  [[nodiscard]] virtual std::string suggested_columns(const Source& data) const = 0;

  /// The report, as one page.
  [[nodiscard]] virtual std::string page(const record::Record& data,
                                         const verdict::Diagnosis& found) const = 0;
  [[nodiscard]] virtual std::string page(const record::Record& data,
                                         const verdict::AddResult& found) const = 0;
  /// The text of its file with the fitted values.
  [[nodiscard]] virtual FittedTexts fitted_texts(const record::Record& data,
                                                 const verdict::Calibration& found) const = 0;

 private:
  About about_;
};

/// Description of a file with all its parts. Throws text::InputError as the readers.
[[nodiscard]] LoopModel::About describe(Messages& messages, const Source& file,
                                        const LoopOptions& options);

/// Names of the records that have values of their own; empty where one model holds for all.
[[nodiscard]] Names records_apart(const fit::Subject& subject);

/// The subject fitted to a record, for a comparison after it. `names`: the parameters to fit.
/// Throws std::invalid_argument for a fit that does not converge.
[[nodiscard]] verdict::Calibration refitted(Messages& messages, const fit::Subject& subject,
                                            const record::Record& data, const Names& names);

/// Opens the requested part of a file, the `place`-th of several, and gives notes on it. Throws
/// text::InputError as the readers and Tolerance, and for a file with several parts of which none
/// is chosen.
[[nodiscard]] std::unique_ptr<LoopModel> open_loop_model(Messages& messages, const Source& file,
                                                         const LoopOptions& options,
                                                         std::size_t place = 0);

/// Opens a file for a question that all its corrections answer alike: of several the first.
[[nodiscard]] std::unique_ptr<LoopModel> open_any_correction(Messages& messages, const Source& file,
                                                             LoopOptions options);

}  // namespace raceway::session
