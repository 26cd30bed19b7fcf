#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/evidence.h"

/// Part of calibrate().
namespace raceway::fit {

/// Readings, what they are weighed by, and whether that is their noise.
struct Weighed {
  Problem problem{};
  Whitening whitening{};
  bool noise_known = false;
  bool as_declared = false;  ///< by declared deviations alone, which may not be all of the noise
  bool by_misfit = false;    ///< and by a scatter beside them that explains what a fit leaves
};

/// What a diagnosis rests on; nothing where the data cannot carry one.
[[nodiscard]] std::optional<Evidence> evidence_of(const Subject& subject, const Record& record);

/// The readings and their weights; `evidence` where a diagnosis could be made.
[[nodiscard]] Weighed weigh(const Subject& subject, const Record& record,
                            const std::optional<Evidence>& evidence,
                            std::vector<std::string>& messages);

}  // namespace raceway::fit
