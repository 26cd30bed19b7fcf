#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "results/correction_results.h"
#include "results/learning_results.h"
#include "session/correction_input.h"

namespace raceway::session {

/// Results of the corrections of a file on a record.
struct CorrectionRun {
  SeriesQuestion asked{};
  std::vector<results::Corrected> corrected{};  ///< of each displacement
  std::vector<record::Note> warnings{};

  [[nodiscard]] std::string json() const;
  /// The rows as CSV.
  [[nodiscard]] std::string csv() const;
  /// The report, as one page.
  [[nodiscard]] std::string page() const;
};

/// Throws text::InputError for a record that does not allow it.
[[nodiscard]] CorrectionRun correct(SeriesQuestion asked);

/// Settings for learning from the readings of a record, as durations with their unit ("4h"); empty:
/// default of LearningOptions.
struct LearningChoices {
  std::string every{}, forget{};

  /// Checks the durations before anything is read. Throws text::InputError for a duration that is
  /// none.
  void check() const;
};

/// Results of learning for the corrections of a file.
struct LearningRun {
  SeriesQuestion asked{};
  std::vector<results::Learnt> learnt{};  ///< of each displacement
  std::vector<record::Note> warnings{}, notes{};

  [[nodiscard]] std::string json() const;
  /// The rows as CSV.
  [[nodiscard]] std::string csv() const;
  /// The file of the models with zero and gains as they stand at the end.
  [[nodiscard]] std::string text() const;
};

/// Throws text::InputError for a record that does not allow it.
[[nodiscard]] LearningRun learn(SeriesQuestion asked, const LearningChoices& choices);

}  // namespace raceway::session
