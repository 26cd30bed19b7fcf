#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/note.h"
#include "verdict/evidence.h"

/// Part of calibrate().
namespace raceway::verdict {

/// Readings, what they are weighed by, and whether that is their noise.
struct Weighed {
  fit::Problem problem{};
  fit::Whitening whitening{};
  bool noise_known = false;
  bool as_declared = false;  ///< by declared deviations alone, which may not be all of the noise
  bool by_misfit = false;    ///< and by a scatter beside them that explains what a fit leaves
};

/// Evidence of a diagnosis; empty if the data cannot carry one.
[[nodiscard]] std::optional<Evidence> evidence_of(const fit::Subject& subject,
                                                  const record::Record& record);

/// The readings and their weights; `evidence` where a diagnosis could be made.
[[nodiscard]] Weighed weigh(const fit::Subject& subject, const record::Record& record,
                            const std::optional<Evidence>& evidence,
                            std::vector<record::Note>& messages);

}  // namespace raceway::verdict
