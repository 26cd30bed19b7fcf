#pragma once

#include <optional>
#include <vector>

#include "fit/subject.h"

namespace raceway::verdict {

/// Noise of one channel that a diagnosis would assume.
struct EstimatedNoise {
  const record::Channel* channel = nullptr;
  double rms = unset;  ///< rms noise over the readings used [SI]
  /// Standard deviations by row of the record [SI]. For unused rows, the standard deviation follows
  /// from the reading.
  std::vector<double> std;
};

/// Estimates the noise (NoiseModel) of each channel of a diagnosis, for data without declared noise
/// and without repeats. The estimate comes from the residual of a regression on smooth surfaces and
/// all candidates, not from the misfit of the model. The result is empty if the data do not support
/// a diagnosis, and for a model that only approximates the readings.
[[nodiscard]] std::optional<std::vector<EstimatedNoise>> estimate_noise_as_diagnosis(
    const fit::Subject& subject, const record::Record& record);

}  // namespace raceway::verdict
