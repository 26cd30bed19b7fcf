#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "results/correction_results.h"
#include "results/learning_results.h"
#include "session/correction_input.h"

namespace raceway::session {

/// What the corrections of a file make of a record.
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

/// Throws text::InputError for what the record does not allow.
[[nodiscard]] CorrectionRun correct(SeriesQuestion asked);

/// How a correction learns from the readings of a record, as durations with their unit ("4h");
/// empty: as LearningOptions has it.
struct LearningChoices {
  std::string every{}, forget{};

  /// Before anything is read. Throws text::InputError for a duration that is none.
  void check() const;
};

/// What the corrections of a file learnt from the readings of a record.
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

/// Throws text::InputError for what the record does not allow.
[[nodiscard]] LearningRun learn(SeriesQuestion asked, const LearningChoices& choices);

}  // namespace raceway::session
