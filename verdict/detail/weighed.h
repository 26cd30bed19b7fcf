#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/note.h"
#include "verdict/evidence.h"

/// Functions that weight the readings for calibrate().
namespace raceway::verdict {

/// Readings with their weights, and the source of these weights.
struct Weighed {
  fit::Problem problem{};
  fit::Whitening whitening{};
  bool noise_known = false;
  /// True: the weights come only from declared standard deviations, which may be smaller than the
  /// noise.
  bool as_declared = false;
  bool by_misfit = false;  ///< true: the fit added a common scatter to the declared deviations
};

/// Returns the Evidence of a diagnosis; empty if a diagnosis of these data is impossible.
[[nodiscard]] std::optional<Evidence> evidence_of(const fit::Subject& subject,
                                                  const record::Record& record);

/// Returns the readings with their weights. If there is `evidence`, its noise determines the
/// weights.
[[nodiscard]] Weighed weigh(const fit::Subject& subject, const record::Record& record,
                            const std::optional<Evidence>& evidence,
                            std::vector<record::Note>& messages);

}  // namespace raceway::verdict
