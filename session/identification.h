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
  std::string order = "1:3";  ///< number of lags of each channel: "2", or a range, "1:3"
  /// columns that may become inputs of the correction; "all" means every input that varies. An
  /// empty list means "all" if `lags` is not empty, otherwise only the inputs of the model
  std::vector<std::string> inputs{};
  /// time constants of the lags [s], the same for all channels. With "auto", the program chooses
  /// the time constants. If the list is empty, the time constants are fitted.
  std::vector<std::string> lags{};
  /// Type of model that is fitted for comparison: "regression", "arx" or empty.
  std::string baseline{};
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};

  /// Checks the options before any file is read. Throws text::InputError for an invalid order or
  /// invalid lags.
  void check() const;
};

/// Corrections identified from one record, one for each displacement of the file.
struct Identified {
  SeriesQuestion asked{};
  std::string baseline{};  ///< type of model that was fitted for comparison: "regression" or empty
  std::vector<correction::Identification> found{};
  /// Errors on the record that validate() reads and that no fit has used, and warnings about this
  /// record. Both lists are empty before validate() is called.
  std::vector<results::Validation> validations{};
  std::vector<record::Note> validation_warnings{};

  /// Validates the models on another record. The errors on `other` then determine the trust in the
  /// models: see correction/trust.h.
  void validate(Messages& messages, const Source& other, const Reading& reading);
  [[nodiscard]] std::string json() const;
  /// Returns the model file with the identified parameters. If a baseline was requested, the file
  /// contains the models of the baseline.
  [[nodiscard]] std::string text() const;
};

/// Identifies the structure and the parameters of all models. Warnings about sensors are also in
/// the notes of the record. Throws text::InputError for an unknown input, missing readings, or a
/// record that does not allow identification. Throws fit::Cancelled if IdentifyChoices::cancelled
/// returns true.
[[nodiscard]] Identified identify(Messages& messages, SeriesQuestion asked,
                                  const IdentifyChoices& choices);

/// ARX models of each requested order, for each displacement of the file.
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
