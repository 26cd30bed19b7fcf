#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "correction/baseline.h"
#include "correction/identify.h"
#include "record/note.h"
#include "results/correction_results.h"
#include "session/correction_input.h"
#include "session/messages.h"
#include "session/source.h"

namespace raceway::session {

/// Command-line options of `raceway identify` in addition to model and record.
struct IdentifyChoices {
  /// Number of lags of each channel, such as "2", or a range of numbers, such as "1:3".
  std::string order = "1:3";
  /// Names of columns that may become inputs of the correction. "all" means every input that
  /// varies. An empty list also means "all" if `lags` is not empty. If both lists are empty, the
  /// correction keeps the inputs of its model file.
  std::vector<std::string> inputs{};
  /// Time constants of the lags [s], the same for all channels. With "auto", the program chooses
  /// the time constants. If the list is empty, the time constants are fitted.
  std::vector<std::string> lags{};
  /// Type of simple model that is fitted instead of the identified model, as a baseline for
  /// comparison: "regression", "arx" or empty.
  std::string baseline{};
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};

  /// Checks `order` and `lags`. Call this function before you read a file. Throws text::InputError
  /// for an invalid order or invalid lags.
  void check() const;
};

/// Corrections identified from one record, one for each displacement of the model file.
struct Identified {
  SeriesQuestion asked{};
  std::string baseline{};  ///< IdentifyChoices::baseline: "regression" or empty
  std::vector<correction::Identification> found{};
  /// Errors of the models on a record that no fit has used (validate()), and warnings about this
  /// record. Both lists are empty until validate() is called.
  std::vector<results::Validation> validations{};
  std::vector<record::Note> validation_warnings{};

  /// Validates the models on another record. The errors on this record then determine the trust in
  /// the models (correction/trust.h).
  void validate(Messages& messages, const Source& other, const Reading& reading);
  [[nodiscard]] std::string json() const;
  /// Returns the model file with the identified parameters. If `baseline` is "regression", the file
  /// contains the regression models instead of the identified models.
  [[nodiscard]] std::string text() const;
};

/// Identifies the structure and the parameters of the correction of each displacement. Warnings
/// about sensors are also added to the notes of the record. Throws text::InputError for an unknown
/// input, missing readings, or a record that does not allow identification. Throws fit::Cancelled
/// if IdentifyChoices::cancelled returns true.
[[nodiscard]] Identified identify(Messages& messages, SeriesQuestion asked,
                                  const IdentifyChoices& choices);

/// ARX (autoregressive) models of each requested order, for each displacement of the model file.
struct ArxModels {
  SeriesQuestion asked{};
  std::vector<std::pair<const record::Channel*, correction::ArxBaseline>> found{};

  /// Model file that contains the ARX models as transfer functions.
  struct Text {
    std::string text{};
    std::vector<record::Note> notes{};
  };
  /// Returns true if every displacement has a stable ARX model.
  [[nodiscard]] bool stable() const;
  [[nodiscard]] std::string json() const;
  /// Returns a model file with the best stable ARX model of each displacement. Throws
  /// text::InputError if a displacement has no stable model.
  [[nodiscard]] Text text() const;
};

/// Fits the ARX models. Throws the same exceptions as identify().
[[nodiscard]] ArxModels identify_arx(SeriesQuestion asked, const IdentifyChoices& choices);

}  // namespace raceway::session
