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
  std::string order = "1:3";  ///< number of sections of each channel, "2", or a range, "1:3"
  /// columns allowed as inputs; "all": every column that varies
  std::vector<std::string> inputs{};
  /// time constants of a bank [s]; "auto" chooses them; empty: sections
  std::vector<std::string> lags{};
  std::string baseline{};  ///< "regression", "arx" or empty
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};

  /// Checks the options before any file is read. Throws text::InputError for an invalid order or
  /// invalid lags.
  void check() const;
};

/// Identifies the structure and the parameters of one model of `asked`. Warnings about sensors are
/// also in the notes of its record. Throws text::InputError for an unknown input, missing readings,
/// or a record that does not allow identification. Throws fit::Cancelled when the user cancels.
[[nodiscard]] correction::Identification identified(Messages& messages, SeriesQuestion& asked,
                                                    const correction::Model& model,
                                                    const IdentifyChoices& choices);

/// Fits an ARX model of every order. Throws like identified().
[[nodiscard]] correction::ArxBaseline arx_baseline(const SeriesQuestion& asked,
                                                   const correction::Model& model,
                                                   const IdentifyChoices& choices);

/// Model file of transfer functions from ARX models, with the best stable order of each
/// displacement.
struct ArxText {
  std::string text{};
  std::vector<record::Note> notes{};
};
/// Throws text::InputError if a displacement has no stable order.
[[nodiscard]] ArxText arx_text(
    const SeriesQuestion& asked,
    const std::vector<std::pair<const record::Channel*, correction::ArxBaseline>>& found);

/// Errors of a model on a record that was not used for its fit, with warnings.
struct Validated {
  results::Validation validation{};
  std::vector<record::Note> warnings{};
};
[[nodiscard]] Validated validated(const correction::Model& model, const record::Record& other);

/// Records a validation as the evidence for the trust in the model: see correction/trust.h. Use it
/// for an identified model.
void judge_by(correction::Model& model, const results::Validation& other);

[[nodiscard]] std::vector<correction::Model> models_of(
    const std::vector<correction::Identification>& found);

/// Returns the model file with the identified numbers. For a baseline, it returns a file of the
/// baseline's own models.
[[nodiscard]] std::string identified_text(const SeriesQuestion& asked,
                                          const std::vector<correction::Model>& found,
                                          const IdentifyChoices& choices);

}  // namespace raceway::session
