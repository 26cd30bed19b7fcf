#pragma once

#include <optional>
#include <vector>

#include "fit/subject.h"

namespace raceway::verdict {

/// Noise of one channel that a diagnosis would assume.
struct EstimatedNoise {
  const record::Channel* channel = nullptr;
  double rms = unset;       ///< over the readings used [SI]
  std::vector<double> std;  ///< by row of the record [SI]; by the reading where a row was not used
};

/// The noise of NoiseModel, of each channel that takes part in a diagnosis, for data that declare
/// none and repeat no rows. It comes from what a regression on smooth surfaces and all candidates
/// leaves, not from the misfit of the subject. Nothing where the data could not carry a diagnosis.
[[nodiscard]] std::optional<std::vector<EstimatedNoise>> estimate_noise_as_diagnosis(
    const fit::Subject& subject, const record::Record& record);

}  // namespace raceway::verdict
