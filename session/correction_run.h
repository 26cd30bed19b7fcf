#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "results/correction_results.h"
#include "results/learning_results.h"
#include "session/correction_input.h"

namespace raceway::session {

/// Displacements that all corrections of a file predict for one record.
struct CorrectionRun {
  SeriesQuestion asked{};
  std::vector<results::Corrected> corrected{};  ///< one result for each displacement
  std::vector<record::Note> warnings{};

  [[nodiscard]] std::string json() const;
  /// Returns a CSV table with the prediction for each row of the record.
  [[nodiscard]] std::string csv() const;
  /// Returns the results as one HTML page.
  [[nodiscard]] std::string page() const;
};

/// Predicts the displacements of the record with all corrections of the file. Throws
/// text::InputError if the record is not suitable.
[[nodiscard]] CorrectionRun correct(SeriesQuestion asked);

/// Settings for a correction that learns from the readings of a record. `every` is the shortest
/// time between two readings that are used. `forget` is the time constant with which learned gains
/// return to the gains of the model. Each time is a text with a unit, such as "4h". An empty text
/// means the default in correction::LearningOptions.
struct LearningChoices {
  std::string every{}, forget{};

  /// Checks the durations. Callers use this function before they read a file. Throws
  /// text::InputError if a text is not a duration.
  void check() const;
};

/// Results of learning: the readings of a record adapt the parameters of all corrections of a file.
struct LearningRun {
  SeriesQuestion asked{};
  std::vector<results::Learnt> learnt{};  ///< one result for each displacement
  std::vector<record::Note> warnings{}, notes{};

  [[nodiscard]] std::string json() const;
  /// Returns a CSV table with the prediction for each row of the record.
  [[nodiscard]] std::string csv() const;
  /// Returns the model file with the gains and offsets that were learned by the end of the record.
  [[nodiscard]] std::string text() const;
};

/// Runs all corrections of the file. Adapts the gains and the offset of each correction to the
/// readings of the record. Throws text::InputError if the record is not suitable.
[[nodiscard]] LearningRun learn(SeriesQuestion asked, const LearningChoices& choices);

}  // namespace raceway::session
