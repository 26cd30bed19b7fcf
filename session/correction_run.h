#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "results/correction_results.h"
#include "results/learning_results.h"
#include "session/correction_input.h"

namespace raceway::session {

/// Results of all corrections of a file on one record.
struct CorrectionRun {
  SeriesQuestion asked{};
  std::vector<results::Corrected> corrected{};  ///< results of each displacement
  std::vector<record::Note> warnings{};

  [[nodiscard]] std::string json() const;
  /// Returns the rows as CSV.
  [[nodiscard]] std::string csv() const;
  /// Returns the report as one HTML page.
  [[nodiscard]] std::string page() const;
};

/// Runs the corrections on the record. Throws text::InputError if the record is not suitable.
[[nodiscard]] CorrectionRun correct(SeriesQuestion asked);

/// Settings for a correction that learns from the readings of a record: `every` is the shortest
/// time between two readings that are used, and `forget` is the time constant with which learned
/// gains return to the gains of the model. Both are texts with a unit ("4h"). An empty text means
/// the default of correction::LearningOptions.
struct LearningChoices {
  std::string every{}, forget{};

  /// Checks the durations before any file is read. Throws text::InputError if a text is not a
  /// duration.
  void check() const;
};

/// Results of all corrections of a file that learn from the readings of a record.
struct LearningRun {
  SeriesQuestion asked{};
  std::vector<results::Learnt> learnt{};  ///< results of each displacement
  std::vector<record::Note> warnings{}, notes{};

  [[nodiscard]] std::string json() const;
  /// Returns the rows as CSV.
  [[nodiscard]] std::string csv() const;
  /// Returns the model file with the zero of each displacement and the gains, as learned by the end
  /// of the record.
  [[nodiscard]] std::string text() const;
};

/// Runs the corrections, and adapts the zero of each displacement and the gains to the readings.
/// Throws text::InputError if the record is not suitable.
[[nodiscard]] LearningRun learn(SeriesQuestion asked, const LearningChoices& choices);

}  // namespace raceway::session
