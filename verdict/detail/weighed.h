#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/note.h"
#include "verdict/evidence.h"

/// Weighs the readings for calibrate().
namespace raceway::verdict {

/// Readings with their weights, and the origin of these weights.
struct Weighed {
  fit::Problem problem{};
  fit::Whitening whitening{};
  bool noise_known = false;
  /// The weights come only from declared deviations, which may be smaller than the noise.
  bool as_declared = false;
  bool by_misfit = false;  ///< true: an additional common scatter accounts for the remaining misfit
};

/// Returns the evidence of a diagnosis; empty if the data do not support a diagnosis.
[[nodiscard]] std::optional<Evidence> evidence_of(const fit::Subject& subject,
                                                  const record::Record& record);

/// Returns the readings with their weights. `evidence` is used if a diagnosis is possible.
[[nodiscard]] Weighed weigh(const fit::Subject& subject, const record::Record& record,
                            const std::optional<Evidence>& evidence,
                            std::vector<record::Note>& messages);

}  // namespace raceway::verdict
