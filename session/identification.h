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

/// Options of `raceway identify` in addition to model and record, as in its command line.
struct IdentifyChoices {
  std::string order = "1:3";          ///< sections of each channel: "2" or "1:3"
  std::vector<std::string> inputs{};  ///< columns that may drive; "all" alone: all that vary
  std::vector<std::string> lags{};    ///< of a bank [s], "auto" alone; empty: sections
  std::string baseline{};             ///< "regression", "arx" or empty
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};

  /// Checks the options before anything is read. Throws text::InputError for an order or lags that
  /// are none.
  void check() const;
};

/// Finds structure and numbers of one of the models of `asked`; warnings of the sensors stand in
/// the notes of its record, too. Throws text::InputError: no such input, no readings, what the
/// record does not allow; and fit::Cancelled.
[[nodiscard]] correction::Identification identified(Messages& messages, SeriesQuestion& asked,
                                                    const correction::Model& model,
                                                    const IdentifyChoices& choices);

/// An ARX model of every order. Throws as identified().
[[nodiscard]] correction::ArxBaseline arx_baseline(const SeriesQuestion& asked,
                                                   const correction::Model& model,
                                                   const IdentifyChoices& choices);

/// ARX models as a model file of transfer functions, the best stable order of each displacement.
struct ArxText {
  std::string text{};
  std::vector<record::Note> notes{};
};
/// Throws text::InputError where no order of a displacement is stable.
[[nodiscard]] ArxText arx_text(
    const SeriesQuestion& asked,
    const std::vector<std::pair<const record::Channel*, correction::ArxBaseline>>& found);

/// Errors of a model on a record that it did not see, with warnings.
struct Validated {
  results::Validation validation{};
  std::vector<record::Note> warnings{};
};
[[nodiscard]] Validated validated(const correction::Model& model, const record::Record& other);

/// Makes that record the evidence for the trust in the model: see correction/trust.h. For an
/// identified model.
void judge_by(correction::Model& model, const results::Validation& other);

[[nodiscard]] std::vector<correction::Model> models_of(
    const std::vector<correction::Identification>& found);

/// The file of the models that were found: that which was asked with its new numbers, or of a
/// baseline one of its own.
[[nodiscard]] std::string identified_text(const SeriesQuestion& asked,
                                          const std::vector<correction::Model>& found,
                                          const IdentifyChoices& choices);

}  // namespace raceway::session
